// SPDX-License-Identifier: MIT
/** A project as a link: #s=... is packed JSON with what differs from the shipped texts. What a link holds is shown, and flies when
 * somebody presses the button: nothing in it is believed to be more than texts for files that are there. And the address of the page,
 * which holds what is edited: reloading, or sending it to somebody, brings it back. */
import { said_in } from '../ui/link.ts';
import { type Project, is_seed, kFirst, scenarios } from './project.ts';

/** Characters of a link, and bytes of what it unpacks to. */
const kLongestLink = 200_000;
const kLargest = 1_000_000;
const kDamaged = 'it is damaged or cut';

async function through(bytes: Uint8Array<ArrayBuffer>, stream: ReadableWritablePair<Uint8Array, BufferSource>, most: number): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) {
      await reader.cancel();
      throw new Error('it is too large');
    }
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts as Uint8Array<ArrayBuffer>[]).arrayBuffer());
}

/** "" if it would be too long to be read. */
export async function link_of({ scenario, seed, edits }: Project): Promise<string> {
  const shared = { v: 1, scenario, ...(seed && { seed }), ...(Object.keys(edits).length && { edits: { ...edits } }) };
  const bytes = new TextEncoder().encode(JSON.stringify(shared));
  const packed = await through(bytes, new CompressionStream('deflate'), Infinity);
  const base64 = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''));
  if (bytes.length > kLargest || base64.length > kLongestLink) return '';
  return `#s=${base64.replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

function checked(value: unknown, shipped: Project['shipped']): Omit<Project, 'shipped'> {
  const is_object = (one: unknown): one is Record<string, unknown> => typeof one === 'object' && one !== null && !Array.isArray(one);
  if (!is_object(value) || value['v'] !== 1) throw new Error('it is of another version');
  const { scenario, seed = '', edits = {} } = value;
  if (typeof scenario !== 'string' || !scenarios(shipped).includes(scenario)) throw new Error('its scenario is not one of these');
  if (typeof seed !== 'string' || (seed && !is_seed(seed))) throw new Error('its seed is no number');
  if (!is_object(edits)) throw new Error('its changes are none');
  const entries = Object.entries(edits).map(([file, text]) => {
    if (!Object.hasOwn(shipped, file)) throw new Error('it changes a file that is not there');
    if (typeof text !== 'string') throw new Error('its changes are no texts');
    if (/\p{Surrogate}/u.test(text)) throw new Error(kDamaged);  // half a character: no file has one
    return [file, text] as const;
  });
  return { scenario, seed, edits: Object.fromEntries(entries) };
}

/** What the fragment of an address holds; null: nothing of ours. Throws an Error that says why it cannot be used. */
export async function read_link(fragment: string, shipped: Project['shipped']): Promise<Project | null> {
  const said = said_in(fragment).get('s');
  if (said === null) return null;
  if (said.length > kLongestLink) throw new Error('it is too long');
  let value: unknown;
  try {
    const packed = Uint8Array.from(atob(said.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
    value = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(await through(packed, new DecompressionStream('deflate'), kLargest)));
  } catch (error) {
    throw new Error(error instanceof Error && error.message === 'it is too large' ? error.message : kDamaged);
  }
  return { shipped, ...checked(value, shipped) };
}

/** ms between two writes while somebody types: browsers take some 10 in a second. */
const kPause = 150;

function is_first({ scenario, seed, edits }: Project): boolean {
  return scenario === kFirst && !seed && !Object.keys(edits).length;
}

/** What the address holds now; null: nothing of ours. */
const said = (): string | null => said_in(location.hash).get('s');

export class Address {
  private readonly first: Project;
  private held: Project;
  private wanted: Project | null;
  /** As it was written or read last; undefined: not yet. */
  private text: string | null | undefined = undefined;
  private reading = false;
  private written = -Infinity;

  constructor(first: Project) {
    this.first = this.held = this.wanted = first;
  }
  /** Whether it brings this back. */
  holds(project: Project): boolean {
    return project === this.held;
  }
  /** ms until it may be written again. */
  get pause(): number {
    return Math.max(0, this.written + kPause - performance.now());
  }
  /** What somebody made of it; null: it says what is edited. What was being written is not any more. Throws an Error that says why it
   * cannot be used: it stays then as it is until something else is edited. */
  async read(edited: Project): Promise<Project | null> {
    const text = said();
    if (text === this.text) return null;
    this.text = text;
    this.wanted = null;
    this.reading = true;
    let read: Project | null = null;
    try {
      const linked = (await read_link(location.hash, this.first.shipped)) ?? this.first;
      if ((await link_of(linked)) !== (await link_of(edited))) read = linked;
    } catch (error) {
      if (text === this.text) throw error;
    } finally {
      if (text === this.text) {
        this.held = read ?? edited;
        this.reading = false;
      }
    }
    return text === this.text ? read : null;
  }
  /** What somebody made of it is not to be read: it is written over. */
  pass_over(): void {
    this.text = said();
  }
  /** False: it cannot hold that much. */
  async write(project: Project): Promise<boolean> {
    if (this.reading) return true;
    this.wanted = project;
    const link = is_first(project) ? '' : await link_of(project);
    if (!link && !is_first(project)) return false;
    if (this.wanted !== project || said() !== this.text) return true;
    const text = said_in(link).get('s');
    if (text !== this.text) history.replaceState(history.state, '', link || location.pathname + location.search);
    this.text = text;
    this.held = project;
    this.written = performance.now();
    return true;
  }
}
