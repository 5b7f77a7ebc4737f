// SPDX-License-Identifier: Apache-2.0
// Says on the room itself how to move, until one has moved for the first time during this visit.
import type { Store } from '../storage';
import { hintTexts as texts } from '../texts';
import { element, setText } from './element';
import type { PointerKind } from './pointer_kind';

const storeKey = 'roomcast.moved';

export class MoveHint {
  private readonly words = element('p');
  private known: boolean;
  private kind: PointerKind = 'mouse';
  private wanted = false;

  /** `store` is kept for the visit. */
  constructor(
    private readonly root: HTMLElement,
    private readonly store: Store,
  ) {
    this.known = store.getItem(storeKey) !== null;
    root.append(this.words);
    this.show();
  }

  setKind(kind: PointerKind): void {
    this.kind = kind;
    this.show();
  }

  /** There is something to see, so that moving makes sense. */
  offer(wanted: boolean): void {
    this.wanted = wanted;
    this.show();
  }

  moved(): void {
    if (this.known) return;
    this.known = true;
    this.store.setItem(storeKey, '1');
    this.show();
  }

  private show(): void {
    this.root.hidden = this.known || !this.wanted;
    setText(this.words, texts[this.kind]);
  }
}
