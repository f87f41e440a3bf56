// SPDX-License-Identifier: MIT
/** What may stand at a place of a scenario, from the JSON schema that the program makes of its catalog. */
import { yamlLanguage } from '@codemirror/lang-yaml';

export interface Schema {
  $ref?: string;
  description?: string;
  type?: string | string[];
  properties?: Record<string, Schema>;
  additionalProperties?: boolean | Schema;
  items?: Schema;
  anyOf?: Schema[];
  oneOf?: Schema[];
  allOf?: Schema[];
  enum?: unknown[];
  const?: unknown;
  pattern?: string;
  definitions?: Record<string, Schema>;
}

/** Where the end of a text is: what the editor's own parser makes of a letter that is written there. The keys that lead there ("-" for an
 * item of a list), whether a key or a value is being written, and what stands of it before the place. */
export function place_of(text: string): { path: string[]; at: 'key' | 'value'; said: string } {
  const written = text.endsWith(':') ? `${text} x` : `${text}x`;
  const last = yamlLanguage.parser.parse(written).resolve(written.length, -1);
  const column = (place: number): number => place - written.lastIndexOf('\n', place - 1);
  // what stands deeper than the key before it, where nothing can stand, is below that
  const before = last.type.isError ? last.prevSibling : null;
  const below = before && column(last.from) > column(before.from) ? before.lastChild : null;
  const path: string[] = [];
  let at: 'key' | 'value' = 'key';
  for (let node = below ?? last; node.parent; node = node.parent) {
    const { parent } = node;
    if (node.name === 'Item') path.unshift('-');
    if (parent.name !== 'Pair' || node.name === 'Key') continue;
    const { from = 0, to = 0 } = parent.getChild('Key') ?? {};
    const in_braces = parent.parent?.name === 'FlowMapping';
    if (!in_braces && column(from) >= column(last.from)) continue;
    path.unshift(text.slice(from, to).replace(/^(["'])(.*)\1$/, '$2'));
    // below its key it is the first key of a map
    if (node === last && (in_braces || !text.slice(to, node.from).includes('\n'))) at = 'value';
  }
  return { path, at, said: text.slice(last.from).trimStart() };
}

export class Grammar {
  constructor(private readonly root: Schema) {}

  /** Every alternative that stands behind references and choices. */
  private flat(schema: Schema, seen = new Set<Schema>()): Schema[] {
    if (seen.has(schema)) return [];
    seen.add(schema);
    const inner = [...(schema.anyOf ?? []), ...(schema.oneOf ?? []), ...(schema.allOf ?? [])];
    const named = schema.$ref ? this.root.definitions?.[schema.$ref.replace('#/definitions/', '')] : undefined;
    return [schema, ...[...inner, ...(named ? [named] : [])].flatMap((one) => this.flat(one, seen))];
  }

  /** What may stand at a path. */
  at(path: readonly string[]): Schema[] {
    return path.reduce((here, key) => here.flatMap((one) => {
      if (key === '-') return one.items ? this.flat(one.items) : [];
      if (one.properties && Object.hasOwn(one.properties, key)) return this.flat(one.properties[key]!);
      return typeof one.additionalProperties === 'object' ? this.flat(one.additionalProperties) : [];
    }), this.flat(this.root));
  }

  /** The keys of maps there, with what each of them is. */
  keys(path: readonly string[]): Map<string, { help: string; nested: boolean }> {
    const keys = new Map<string, { help: string; nested: boolean }>();
    for (const { properties = {} } of this.at(path))
      for (const [key, schema] of Object.entries(properties)) {
        const all = this.flat(schema);
        const help = all.find((one) => one.description)?.description ?? '';
        const scalar = all.some((one) => one.enum || one.pattern || [one.type].flat().some((type) => ['string', 'number', 'integer', 'boolean'].includes(String(type))));
        if (!keys.has(key)) keys.set(key, { help, nested: !scalar });
      }
    return keys;
  }

  /** The words that may stand there. */
  words(path: readonly string[]): string[] {
    const words = this.at(path).flatMap((one) => [...(one.enum ?? []), ...(one.type === 'boolean' ? [true, false] : [])]);
    return [...new Set(words.map(String))];
  }

  /** The units of a quantity there. */
  units(path: readonly string[]): string[] {
    const units = this.at(path).flatMap(({ pattern }) => /\[ \\t\]\*\(([^()]+)\)\[ \\t\]\*\$$/.exec(pattern ?? '')?.[1]?.split('|') ?? []);
    return [...new Set(units)].filter(Boolean);
  }

  help(path: readonly string[]): string {
    return this.keys(path.slice(0, -1)).get(path.at(-1) ?? '')?.help ?? '';
  }
}
