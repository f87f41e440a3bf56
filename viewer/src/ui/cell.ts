// SPDX-License-Identifier: MIT
/** One value that panels share and follow. */
export class Cell<T> {
  private readonly listeners = new Set<(value: T) => void>();

  constructor(private value: T) {}
  get(): T {
    return this.value;
  }
  set(value: T): void {
    if (Object.is(value, this.value)) return;
    this.value = value;
    for (const listener of this.listeners) listener(value);
  }
  /** Returns how to stop listening. */
  subscribe(listener: (value: T) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
