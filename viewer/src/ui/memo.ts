// SPDX-License-Identifier: MIT
/** A component that is drawn again only if one of its properties is another one. */
import { Component, createElement, type ComponentChildren, type FunctionComponent } from 'preact';

export function memo_by<P extends object>(draw: (props: P) => ComponentChildren): FunctionComponent<P> {
  class Kept extends Component<P> {
    override shouldComponentUpdate(next: Readonly<P>): boolean {
      const keys = Object.keys(next) as (keyof P)[];
      return keys.some((key) => !Object.is(next[key], (this.props as P)[key]));
    }
    override render(): ComponentChildren {
      return draw(this.props as P);
    }
  }
  return (props: P) => createElement(Kept, props);
}
