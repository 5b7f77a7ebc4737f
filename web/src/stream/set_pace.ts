// SPDX-License-Identifier: Apache-2.0
// Lets at most so many frame sets a second through, evenly. Pure.

export class SetPace {
  private interval_ms = 0; // 0: all
  private due_ms = 0;

  /** 0: all. */
  set(fps: number): void {
    this.interval_ms = fps > 0 ? 1000 / fps : 0;
    this.due_ms = 0;
  }

  takes(now_ms: number): boolean {
    if (this.interval_ms === 0) return true;
    if (now_ms < this.due_ms) return false;
    // The rate is kept although sets come at times of their own; after a pause it begins anew.
    this.due_ms = Math.max(this.due_ms + this.interval_ms, now_ms);
    return true;
  }
}
