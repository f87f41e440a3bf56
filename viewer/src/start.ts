// SPDX-License-Identifier: MIT
/** Unpacks the code of a page and starts it. */
import { unpacked } from './packed.ts';

const code = new Blob([await unpacked(document.getElementById('code')!)], { type: 'text/javascript' });
await import(URL.createObjectURL(code));
