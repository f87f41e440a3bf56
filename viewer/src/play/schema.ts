// SPDX-License-Identifier: MIT
/** What may stand at a place of a scenario, from the JSON schema that the program makes of its catalog. */

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

/** Where in a text: the keys that lead there ("-" for an item of a list), and whether a key or a value is being written. */
export interface Place {
  path: string[];
  at: 'key' | 'value';
  said: string;  // What stands of the key or value before the place.
}

const kKey = /^("[^"]*"|'[^']*'|[^\s#{}[\],&*!|>'"%@`:-][^#{}[\],:]*|-[^\s#{}[\],:]+)\s*:(?=\s|$)/;
const kDash = /^-(\s+|$)/;
const bare = (key: string): string => key.trim().replace(/^(["'])(.*)\1$/, '$2');

/** Follows a line through the braces that are open in it, each with the key that it is at: "" for a map without one so far, "-" for a
 * list. Gives the word that is being written at its end. */
function follow_braces(line: string, open: string[]): string {
  let word = '';
  for (const { 0: token, groups } of line.matchAll(/(?<comment>(?<!\S)#.*)|"[^"]*"?|'[^']*'?|(?<colon>:(?!\S))|[^]/g)) {
    const last = open.length - 1;
    const is_list = open[last] === '-';
    if (groups!['comment'] !== undefined) break;
    if (token === '{' || token === '[') open.push(token === '{' ? '' : '-');
    else if (token === '}' || token === ']') open.pop();
    else if (token === ',') open[last] = is_list ? '-' : '';
    else if (groups!['colon'] && !is_list) open[last] = bare(word);
    else {
      word += token;
      continue;
    }
    word = '';
    if (!open.length) break;
  }
  return word.trimStart();
}

/** Where the end of a text is. */
export function place_of(text: string): Place {
  const block: { column: number; key: string }[] = [];
  const open: string[] = [];
  let at: Place['at'] = 'key';
  let said = '';
  const close = (is_over: (one: (typeof block)[number]) => boolean): void => {
    while (block.length && is_over(block.at(-1)!)) block.pop();
  };
  const lines = text.split('\n');
  for (const line of lines) {
    let column = line.search(/\S|$/);
    let rest = open.length ? line : line.slice(column);
    if (!open.length) {
      said = rest;
      if (rest.startsWith('#')) continue;
      at = 'key';
      if (rest) close((one) => one.column > column);
      for (let dash = kDash.exec(rest); dash; dash = kDash.exec(rest)) {
        // an item may stand in the column of the key that it belongs to
        close(({ column: other, key }) => other > column || (other === column && key === '-'));
        block.push({ column, key: '-' });
        column += dash[0].length;
        said = rest = rest.slice(dash[0].length);
      }
      const key = kKey.exec(rest);
      if (key) {
        close((one) => one.column >= column);
        block.push({ column, key: bare(key[1]!) });
        at = 'value';
        rest = rest.slice(key[0].length);
        said = rest.trimStart();
      }
      if (!/^\s*[{[]/.test(rest)) continue;
    }
    said = follow_braces(rest, open);
    at = open.length && !['', '-'].includes(open.at(-1)!) ? 'value' : 'key';
  }
  const column = open.length || at === 'value' ? Infinity : lines.at(-1)!.length - said.length;
  const path = [...block.filter((one) => one.column < column).map(({ key }) => key), ...open].filter((key) => key !== '');
  return { path, at, said };
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
