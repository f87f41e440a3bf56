// SPDX-License-Identifier: MIT
import { from_ascii85 } from '../ascii85.mjs';

/** What a script element of a page carries: a zlib stream as text. */
export async function unpacked(script: Element): Promise<Uint8Array<ArrayBuffer>> {
  const packed = new Blob([from_ascii85(script.textContent!.trim())]);
  return new Uint8Array(await new Response(packed.stream().pipeThrough(new DecompressionStream('deflate'))).arrayBuffer());
}
