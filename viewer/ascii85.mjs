// SPDX-License-Identifier: MIT
// Bytes as the text of a script element: Ascii85, a quarter longer than they are. 'v' stands for '<', which HTML may take
// for its own.

const kBase = 85, kFirst = 33, kMark = 60, kForMark = 118; // '!', '<', 'v'

/** @param {Uint8Array} bytes @returns {string} */
export function ascii85(bytes) {
  let text = '';
  for (let at = 0; at < bytes.length; at += 4) {
    let word = 0;
    for (let k = 0; k < 4; ++k) word = word * 256 + (bytes[at + k] ?? 0);
    let digits = '';
    for (let k = 0; k < 5; ++k) {
      const digit = kFirst + (word % kBase);
      digits = String.fromCharCode(digit === kMark ? kForMark : digit) + digits;
      word = Math.floor(word / kBase);
    }
    text += digits.slice(0, bytes.length - at + 1);
  }
  return text;
}

/** What ascii85() was given; of another text anything.
 * @param {string} text @returns {Uint8Array<ArrayBuffer>} */
export function from_ascii85(text) {
  const view = new DataView(new ArrayBuffer(Math.ceil(text.length / 5) * 4));
  for (let at = 0, to = 0; at < text.length; at += 5, to += 4) {
    let word = 0;
    for (let k = 0; k < 5; ++k) {
      const digit = at + k < text.length ? text.charCodeAt(at + k) : kFirst + kBase - 1;
      word = word * kBase + (digit === kForMark ? kMark : digit) - kFirst;
    }
    view.setUint32(to, word);
  }
  return new Uint8Array(view.buffer, 0, Math.floor(text.length / 5 * 4));
}
