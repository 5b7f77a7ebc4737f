// SPDX-License-Identifier: Apache-2.0
// Measures how long it takes from the wish for another moment of a recording until every sensor has a picture from there,
// and until every sensor shows exactly that moment. Pure.
import type { PlaybackState } from '../stream/protocol';

interface ShownFrame {
  sensor: number;
  seq: number;
}

export class SeekWatch {
  first_ms: number | undefined; // until a picture of every sensor was drawn
  exact_ms: number | undefined; // until the moment itself was drawn
  private asked_ms: number | undefined;
  private seeks = 0;
  private isBegun = false;
  private moment: PlaybackState['moment'] = [];
  private readonly drawn = new Map<number, number>(); // seq of each sensor

  asked(now_ms: number): void {
    this.asked_ms = now_ms;
    this.first_ms = this.exact_ms = undefined;
    this.isBegun = false;
  }

  take({ seeks, moment }: Pick<PlaybackState, 'seeks' | 'moment'>): void {
    if (seeks !== this.seeks) {
      this.seeks = seeks;
      this.isBegun = true;
      this.drawn.clear();
    }
    this.moment = moment;
  }

  show(frames: readonly ShownFrame[], now_ms: number): void {
    if (this.asked_ms === undefined || !this.isBegun) return;
    for (const { sensor, seq } of frames) this.drawn.set(sensor, seq);
    if (this.moment.length === 0 || !this.moment.every(({ sensor }) => this.drawn.has(sensor))) return;
    this.first_ms ??= now_ms - this.asked_ms;
    if (!this.moment.every(({ sensor, seq }) => this.drawn.get(sensor)! >= seq)) return;
    this.exact_ms ??= now_ms - this.asked_ms;
    this.asked_ms = undefined;
  }
}
