// SPDX-License-Identifier: Apache-2.0
// Chooses the drawing quality so that drawing keeps up: steps of the depth grid and of the screen, and the number of
// sensors, by the measured drawing time. Starts in the middle, so that the first picture comes soon on any machine;
// lower without a graphics processor.

export interface Quality {
  step: number; // every step-th pixel of the depth grid
  pixelRatio: number; // relative to the screen's own
  sensors: number; // at most; those that cover most of the view
  mixes: boolean; // blends surfaces; else only the nearest is drawn, at a third of the cost
}

export const qualities: readonly Quality[] = [
  { step: 1, pixelRatio: 1, sensors: 16, mixes: true },
  { step: 2, pixelRatio: 1, sensors: 12, mixes: true },
  { step: 3, pixelRatio: 1, sensors: 8, mixes: true },
  { step: 4, pixelRatio: 1, sensors: 6, mixes: true },
  { step: 4, pixelRatio: 1, sensors: 6, mixes: false },
  { step: 4, pixelRatio: 0.75, sensors: 4, mixes: false },
  { step: 5, pixelRatio: 0.6, sensors: 3, mixes: false }, // coarser steps hardly save time, and thin objects disappear
];

/** As finely as the machine can keep up with, or always the same rung. */
export const qualityChoices = ['auto', 'best', 'fine', 'medium', 'coarse'] as const;
export type QualityChoice = (typeof qualityChoices)[number];
const rungOf: Record<Exclude<QualityChoice, 'auto'>, number> = { best: 0, fine: 1, medium: 3, coarse: 6 };

const firstRung = 3;
const firstRungInSoftware = 4;
const drawsToJudge = 6;
const patience_ms = 3000; // from a step down to the next attempt to go up; doubles after a failed attempt
const longestPatience_ms = 60_000;

/** Time limit of a picture: on a screen, or in a headset, where a late picture is noticeable. */
export interface Pace {
  tooSlow_ms: number;
  quick_ms: number; // fast enough to try the next quality up
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

  /** Anything but 'auto' is drawn regardless of the time it takes. */
  choose(choice: QualityChoice): void {
    this.pinned = choice !== 'auto';
    this.draws = [];
    if (choice !== 'auto') this.rung = rungOf[choice];
  }

  /** `draw_ms` is the drawing time of a picture, `now_ms` any monotonic clock. True when the quality has changed. */
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
