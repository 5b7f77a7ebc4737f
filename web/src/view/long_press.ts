// SPDX-License-Identifier: Apache-2.0
// Recognises a long press: one finger, or the main button, that stays at its place. Pixels, milliseconds. Pure.

const least_ms = 450;
const slack_px = 8;

export interface Press {
  id: number; // of the pointer
  x: number;
  y: number;
}

export class LongPress {
  private begun: (Press & { at_ms: number }) | undefined;

  down(press: Press, at_ms: number): void {
    this.begun = { ...press, at_ms };
  }

  /** Farther than a hand shakes, it is a drag. */
  move({ id, x, y }: Press): void {
    if (this.begun?.id === id && Math.hypot(x - this.begun.x, y - this.begun.y) > slack_px) this.cancel();
  }

  cancel(): void {
    this.begun = undefined;
  }

  /** The press that has become a long one; once for each. */
  due(now_ms: number): Press | undefined {
    const { begun } = this;
    if (!begun || now_ms - begun.at_ms < least_ms) return undefined;
    this.cancel();
    return begun;
  }
}
