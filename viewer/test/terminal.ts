// SPDX-License-Identifier: MIT
/** What the program says with --json, and its command lines as the page writes them. */

interface FieldJson { name: string; flown: string; other: string }
export interface WhatIfJson {
  decisions: number;
  different: number;
  first?: { time_s: number; step: number; leader: { flown: string; other: string }; fields: FieldJson[] };
}

/** The words of a command line, without quotes, as a shell takes them. */
export function words_of(command: string): string[] {
  return [...command.matchAll(/'((?:[^']|'\\'')*)'|(\S+)/g)].map(([, quoted, plain]) => plain ?? quoted!.replaceAll("'\\''", "'"));
}
