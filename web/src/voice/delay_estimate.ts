// SPDX-License-Identifier: Apache-2.0
// How late packets of a speaker arrive, and how long to wait for them. Only differences count, so capture and arrival
// may be by different clocks. Source: adaptive playout after Ramjee et al., "Adaptive playout mechanisms for packetized
// audio applications in wide-area networks" (INFOCOM 1994), with a percentile of the lateness instead of its variance.

export const leastTarget_ms = 20;
export const mostTarget_ms = 200;
const firstTarget_ms = 40;
const margin_ms = 10;
const wanted = 0.98; // of the packets are in time
const window = 250; // packets
const lowered_ms = 2; // at a time
const adaptEvery = 10; // packets
const baseline_ms = 10_000; // the shortest delay of this time and the one before it

export class DelayEstimate {
  target_ms = firstTarget_ms;
  private readonly lateness = new Float32Array(window);
  private count = 0;
  private least = Infinity; // arrival - capture
  private leastBefore = Infinity;
  private begun_ms = -Infinity;

  /** The shortest way of late, arrival - capture. */
  get shortest_ms(): number {
    return Math.min(this.least, this.leastBefore);
  }

  arrived(capture_ms: number, now_ms: number): void {
    const way_ms = now_ms - capture_ms;
    if (now_ms - this.begun_ms > baseline_ms) {
      this.leastBefore = this.least;
      this.least = Infinity;
      this.begun_ms = now_ms;
    }
    this.least = Math.min(this.least, way_ms);
    const late_ms = way_ms - this.shortest_ms;
    this.lateness[this.count++ % window] = late_ms;
    if (late_ms + margin_ms > this.target_ms) this.target_ms = Math.min(mostTarget_ms, this.raised(late_ms));
    else if (this.count % adaptEvery === 0) this.lower();
  }

  /** A single late packet raises it half of the way: it may remain the only one. */
  private raised(late_ms: number): number {
    return Math.max(this.target_ms, (this.target_ms + late_ms + margin_ms) / 2);
  }

  private lower(): void {
    const known = this.lateness.slice(0, Math.min(this.count, window)).sort();
    const needed_ms = known[Math.min(known.length - 1, Math.floor(wanted * known.length))]! + margin_ms;
    const goal_ms = Math.max(leastTarget_ms, needed_ms);
    if (goal_ms < this.target_ms) this.target_ms = Math.max(goal_ms, this.target_ms - lowered_ms);
  }
}
