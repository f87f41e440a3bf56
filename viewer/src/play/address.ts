// SPDX-License-Identifier: MIT
/** The address holds what is edited: reloading, or sending it to somebody, brings it back. A moment that it names stays until something
 * else is edited. */
import { said_in } from '../ui/link.ts';
import { kFirst, type Project } from './project.ts';
import { link_of } from './share.ts';

/** ms between two writes while somebody types: browsers take some 10 in a second. */
const kPause = 150;

function is_first({ scenario, seed, edits }: Project): boolean {
  return scenario === kFirst && !seed && !Object.keys(edits).length;
}

export class Address {
  private held: Project;
  private wanted: Project;
  private written = -Infinity;

  constructor(first: Project) {
    this.held = this.wanted = first;
  }
  /** Whether it brings this back. */
  holds(project: Project): boolean {
    return project === this.held;
  }
  /** It stays as it is as long as this is shown. */
  keep(project: Project): void {
    this.held = this.wanted = project;
  }
  /** ms until it may be written again. */
  get pause(): number {
    return Math.max(0, this.written + kPause - performance.now());
  }
  /** False: it cannot hold that much. */
  async write(project: Project): Promise<boolean> {
    this.wanted = project;
    const link = is_first(project) ? '' : await link_of(project);
    if (!link && !is_first(project)) return false;
    if (this.wanted !== project) return true;
    if (said_in(link).get('s') !== said_in(location.hash).get('s')) history.replaceState(history.state, '', link || location.pathname + location.search);
    this.held = project;
    this.written = performance.now();
    return true;
  }
}
