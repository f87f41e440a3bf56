// SPDX-License-Identifier: MIT
/** build.mjs bundles the worker into a text. */
declare module 'worker:./worker.ts' {
  const code: string;
  export default code;
}
