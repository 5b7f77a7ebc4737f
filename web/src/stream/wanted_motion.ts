// SPDX-License-Identifier: Apache-2.0
// Tells the worker when it is to find how things move: while surfaces of several sensors are blended, and not in the first
// moments of a visit, so that the module for it does not delay the room.
import type { Drawing } from '../view/draw_mode';

const afterFirstPicture_ms = 1500;

export class WantedMotion {
  private firstPicture_ms: number | undefined;
  private isWanted = false;

  constructor(private readonly tell: (isWanted: boolean) => void) {}

  /** Frames have been drawn. */
  drawn({ mode, mixes, shown }: Drawing, now_ms: number): void {
    this.firstPicture_ms ??= now_ms;
    const isLater = now_ms - this.firstPicture_ms >= afterFirstPicture_ms;
    const isWanted = isLater && mode === 'blend' && mixes && shown >= 2;
    if (isWanted === this.isWanted) return;
    this.isWanted = isWanted;
    this.tell(isWanted);
  }
}
