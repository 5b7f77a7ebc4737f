// SPDX-License-Identifier: Apache-2.0
// Growth of a counter per second, over the last two seconds.

const window_ms = 2000;

export class RateMeter {
  private readings: { at_ms: number; total: number }[] = [];

  /** `total` never decreases. If it does (the other side restarted), the meter restarts as well. */
  count(at_ms: number, total: number): void {
    const last = this.readings.at(-1);
    if (last && total < last.total) this.readings = [];
    this.readings.push({ at_ms, total });
    while (this.readings.length > 2 && this.readings[1]!.at_ms <= at_ms - window_ms) this.readings.shift();
  }

  /** With `now_ms`, the rate of a counter that is no longer reported decreases to 0. */
  perSecond(now_ms?: number): number {
    const first = this.readings[0];
    const last = this.readings.at(-1);
    if (!first || !last || first === last) return 0;
    if (now_ms !== undefined && now_ms - last.at_ms > window_ms) return 0;
    const seconds = (Math.max(last.at_ms, now_ms ?? 0) - first.at_ms) / 1000;
    return seconds > 0 ? (last.total - first.total) / seconds : 0;
  }
}
