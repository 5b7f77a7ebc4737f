// SPDX-License-Identifier: Apache-2.0
// When samples were recorded, by the page's clock: blocks of samples arrive late by varying times, so the earliest
// arrivals count. Their difference to the sample count is followed for a while, as the two clocks drift.
import { sampleRate_hz } from './voice_packet';

const window_ms = 10_000;

export class SampleClock {
  private least_ms = Infinity; // page time - time of the sample count
  private before_ms = Infinity;
  private begun_ms = -Infinity;

  /** Page time of sample number `first`, of a block of `count` samples that has arrived at `now_ms`. */
  timeOf(first: number, count: number, now_ms: number): number {
    const difference_ms = now_ms - (1000 * (first + count)) / sampleRate_hz;
    if (now_ms - this.begun_ms > window_ms) {
      this.before_ms = this.least_ms;
      this.least_ms = Infinity;
      this.begun_ms = now_ms;
    }
    this.least_ms = Math.min(this.least_ms, difference_ms);
    return Math.min(this.least_ms, this.before_ms) + (1000 * first) / sampleRate_hz;
  }
}
