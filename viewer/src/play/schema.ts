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
const bare = (key: string): string => key.trim().replace(/^(["'])(.*)\1$/, '$2');

/** Follows a text line by line. */
class Follower {
  /** Of the block that is open: each key or item with its column. */
  private readonly block: { column: number; key: string }[] = [];
  /** Of the braces that are open in it: "" for a map without a key so far, "-" for a list. */
  private readonly flow: string[] = [];
  private at: Place['at'] = 'key';
  private said = '';

  line(text: string): void {
    if (this.flow.length) return this.inside(text);
    let column = text.search(/\S|$/);
    let rest = text.slice(column);
    this.said = rest;
    if (rest.startsWith('#')) return;
    this.at = 'key';
    if (rest) this.close(({ column: other }) => other > column);
    for (let dash = /^-(\s+|$)/.exec(rest); dash; dash = /^-(\s+|$)/.exec(rest)) {
      // an item may stand in the column of the key that it belongs to
      this.close(({ column: other, key }) => other > column || (other === column && key === '-'));
      this.block.push({ column, key: '-' });
      column += dash[0].length;
      rest = rest.slice(dash[0].length);
    }
    const key = kKey.exec(rest);
    this.said = rest;
    if (key) {
      this.close(({ column: other }) => other >= column);
      this.block.push({ column, key: bare(key[1]!) });
      this.at = 'value';
      rest = rest.slice(key[0].length);
      this.said = rest.trimStart();
    }
    if (/^\s*[{[]/.test(rest)) this.inside(rest);
  }

  private close(is_over: (open: { column: number; key: string }) => boolean): void {
    while (this.block.length && is_over(this.block.at(-1)!)) this.block.pop();
  }

  private inside(text: string): void {
    const { flow } = this;
    let word = '';
    for (let i = 0; i < text.length; ++i) {
      const c = text[i]!;
      if (c === '"' || c === "'") {
        const end = text.indexOf(c, i + 1);
        word += text.slice(i, end < 0 ? undefined : end + 1);
        i = end < 0 ? text.length : end;
      } else if (c === '#' && /\s/.test(text[i - 1] ?? ' ')) {
        break;
      } else if (c === '{' || c === '[') {
        flow.push(c === '{' ? '' : '-');
        word = '';
      } else if (c === '}' || c === ']') {
        flow.pop();
        word = '';
        if (!flow.length) break;
      } else if (c === ',') {
        if (flow.at(-1) !== '-') flow[flow.length - 1] = '';
        word = '';
      } else if (c === ':' && /^(\s|$)/.test(text[i + 1] ?? '') && flow.at(-1) !== '-') {
        flow[flow.length - 1] = bare(word);
        word = '';
      } else {
        word += c;
      }
    }
    this.said = word.trimStart();
    this.at = flow.length && flow.at(-1) !== '' && flow.at(-1) !== '-' ? 'value' : 'key';
  }

  /** The place behind the last line, of which `text` was all. */
  place(text: string): Place {
    const column = this.flow.length || this.at === 'value' ? Infinity : text.length - this.said.length;
    const block = this.block.filter((one) => one.column < column);
    const path = [...block.map(({ key }) => key), ...this.flow].filter((key) => key !== '');
    return { path, at: this.at, said: this.said };
  }
}

/** Where the end of a text is. */
export function place_of(text: string): Place {
  const follower = new Follower();
  const lines = text.split('\n');
  for (const line of lines) follower.line(line);
  return follower.place(lines.at(-1)!);
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
        const scalar = all.some((one) => one.enum || one.pattern || ['string', 'number', 'integer', 'boolean'].includes(String(one.type)));
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
