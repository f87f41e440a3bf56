// SPDX-License-Identifier: MIT
/** A project as a link: #s=... is packed JSON with what differs from the shipped texts. What a link holds is shown, and flies when
 * somebody presses the button: nothing in it is believed to be more than texts for files that are there. */
import { said_in } from '../ui/link.ts';
import { is_seed, scenarios, type Project } from './project.ts';

/** Characters of a link, and bytes of what it unpacks to. */
const kLongestLink = 200_000;
const kLargest = 1_000_000;
const kDamaged = 'it is damaged or cut';

interface Shared {
  v: 1;
  scenario: string;
  seed?: string;
  edits?: Record<string, string>;
}

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
  const shared: Shared = { v: 1, scenario, ...(seed && { seed }), ...(Object.keys(edits).length && { edits: { ...edits } }) };
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
