// SPDX-License-Identifier: Apache-2.0
// How finely to draw, so that drawing keeps up: steps of the depth grid and of the screen, and how many sensors, chosen
// by how long the graphics processor took. Starts in the middle, so that the first picture comes soon on any machine;
// where there is no graphics processor, lower.

export interface Quality {
  step: number; // every step-th pixel of the depth grid
  pixelRatio: number; // of the screen's own
  sensors: number; // at most, those that show most of what is looked at
  mixes: boolean; // surfaces are mixed; else the nearest wins, which costs a third
}

export const qualities: readonly Quality[] = [
  { step: 1, pixelRatio: 1, sensors: 16, mixes: true },
  { step: 2, pixelRatio: 1, sensors: 12, mixes: true },
  { step: 3, pixelRatio: 1, sensors: 8, mixes: true },
  { step: 4, pixelRatio: 1, sensors: 6, mixes: true },
  { step: 4, pixelRatio: 1, sensors: 6, mixes: false },
  { step: 4, pixelRatio: 0.75, sensors: 4, mixes: false },
  { step: 5, pixelRatio: 0.6, sensors: 3, mixes: false }, // coarser than this hardly saves time, and thin things disappear
];

const firstRung = 3;
const firstRungInSoftware = 4;
const drawsToJudge = 6;
const patience_ms = 3000; // after coming down, before trying to go up again; doubles when going up was a mistake
const longestPatience_ms = 60_000;

/** How long a picture may take: on a screen, or in a headset, where a late one is felt. */
export interface Pace {
  tooSlow_ms: number;
  quick_ms: number; // worth trying a rung up
}

export const screenPace: Pace = { tooSlow_ms: 60, quick_ms: 40 };
export const headsetPace: Pace = { tooSlow_ms: 16, quick_ms: 9 };

export class QualityLadder {
  private rung: number;
  private draws: number[] = [];
  private mayRiseAt_ms = 0;
  private patience_ms = patience_ms;
  private roseLast = false;
  private pace = screenPace;
  private pinned = false;

  constructor(inSoftware = false) {
    this.rung = inSoftware ? firstRungInSoftware : firstRung;
  }

  get quality(): Quality {
    return qualities[this.rung]!;
  }

  setPace(pace: Pace): void {
    this.pace = pace;
    this.draws = [];
  }

  /** As finely as possible, however long it takes. */
  pinToBest(): void {
    this.rung = 0;
    this.pinned = true;
  }

  /** `draw_ms` is how long a picture took, `now_ms` any steady clock. True when the quality has changed. */
  judge(draw_ms: number, now_ms: number): boolean {
    if (this.pinned) return false;
    this.draws.push(draw_ms);
    if (this.draws.length < drawsToJudge) return false;
    const median = [...this.draws].sort((a, b) => a - b)[drawsToJudge >> 1]!;
    this.draws = [];
    if (median > this.pace.tooSlow_ms && this.rung < qualities.length - 1) return this.fall(now_ms);
    if (median < this.pace.quick_ms && this.rung > 0 && now_ms >= this.mayRiseAt_ms) return this.rise();
    return false;
  }

  private fall(now_ms: number): boolean {
    this.rung++;
    if (this.roseLast) this.patience_ms = Math.min(2 * this.patience_ms, longestPatience_ms);
    this.roseLast = false;
    this.mayRiseAt_ms = now_ms + this.patience_ms;
    return true;
  }

  private rise(): boolean {
    this.rung--;
    this.roseLast = true;
    return true;
  }
}
