// SPDX-License-Identifier: Apache-2.0
// Recognises a double click or double tap: two short touches of the same place by one finger or the main button. The
// browser's own event does not come for fingers on a page that handles touches itself. Pixels, milliseconds. Pure.

const longestTap_ms = 250;
const longestPause_ms = 350;
const clickSlack_px = 8;
const pairSlack_px = 40; // a finger does not meet the same place

interface Touch {
  x: number;
  y: number;
  at_ms: number;
}

export class DoubleTap {
  private begun: Touch | undefined;
  private first: Touch | undefined;

  down(x: number, y: number, at_ms: number): void {
    this.begun = { x, y, at_ms };
  }

  /** Another finger, a drag by another button: neither this touch nor the one before counts. */
  cancel(): void {
    this.begun = this.first = undefined;
  }

  /** True when this ends the second touch. */
  up(x: number, y: number, at_ms: number): boolean {
    const { begun, first } = this;
    this.cancel();
    if (!begun || at_ms - begun.at_ms > longestTap_ms || apart(begun, { x, y }) > clickSlack_px) return false;
    const isSecond = first && begun.at_ms - first.at_ms < longestPause_ms && apart(first, begun) < pairSlack_px;
    if (!isSecond) this.first = { x, y, at_ms };
    return isSecond === true;
  }
}

function apart(a: { x: number; y: number }, b: { x: number; y: number }): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
