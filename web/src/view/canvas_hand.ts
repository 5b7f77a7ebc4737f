// SPDX-License-Identifier: Apache-2.0
// What takes a pointer that is pressed on the canvas instead of the navigation: the laser pointer, a tool. Pixels are
// CSS pixels of the canvas.

export interface CanvasHand {
  press(x: number, y: number): void;
  drag(x: number, y: number): void;
  release(): void;
  /** The press meant something else: a second finger came, or the browser took the pointer. */
  cancel(): void;
}
