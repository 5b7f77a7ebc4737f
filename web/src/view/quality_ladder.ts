// SPDX-License-Identifier: Apache-2.0
// How finely to draw, so that drawing keeps up: steps of the depth grid and of the screen, chosen by how long the
// graphics processor took. Starts in the middle, so that the first picture comes soon on any machine.

export interface Quality {
  step: number; // every step-th pixel of the depth grid
  pixelRatio: number; // of the screen's own
}

export const qualities: readonly Quality[] = [
  { step: 1, pixelRatio: 1 },
  { step: 2, pixelRatio: 1 },
  { step: 3, pixelRatio: 1 },
  { step: 4, pixelRatio: 1 },
  { step: 4, pixelRatio: 0.75 },
  { step: 5, pixelRatio: 0.6 }, // coarser than this hardly saves time, and thin things disappear
];

const firstRung = 3;
const tooSlow_ms = 60;
const quick_ms = 40; // worth trying a rung up
const drawsToJudge = 6;
const patience_ms = 3000; // after coming down, before trying to go up again; doubles when going up was a mistake
const longestPatience_ms = 60_000;

export class QualityLadder {
  private rung = firstRung;
  private draws: number[] = [];
  private mayRiseAt_ms = 0;
  private patience_ms = patience_ms;
  private roseLast = false;

  get quality(): Quality {
    return qualities[this.rung]!;
  }

  /** `draw_ms` is how long a picture took, `now_ms` any steady clock. True when the quality has changed. */
  judge(draw_ms: number, now_ms: number): boolean {
    this.draws.push(draw_ms);
    if (this.draws.length < drawsToJudge) return false;
    const median = [...this.draws].sort((a, b) => a - b)[drawsToJudge >> 1]!;
    this.draws = [];
    if (median > tooSlow_ms && this.rung < qualities.length - 1) return this.fall(now_ms);
    if (median < quick_ms && this.rung > 0 && now_ms >= this.mayRiseAt_ms) return this.rise();
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
