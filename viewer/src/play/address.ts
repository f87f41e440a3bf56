// SPDX-License-Identifier: MIT
/** The address holds what is edited: reloading, or sending it to somebody, brings it back. A moment that it names stays until something
 * else is edited. Whoever changes it, by the ways back and forward or by hand, is read before anything else is written. */
import { said_in } from '../ui/link.ts';
import { kFirst, type Project } from './project.ts';
import { link_of, read_link } from './share.ts';

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
