// SPDX-License-Identifier: Apache-2.0
// The position in a recording that is played: it advances with the time unless it is paused, or held because something is
// awaited. Pure; `now_ms` is any clock that advances steadily.

export class PlaybackClock {
  private from_s = 0; // position at `since_ms`
  private since_ms = 0;
  private isPaused = false;
  private isHeld = false;
  private rate = 1;

  constructor(private readonly now_ms: () => number) {
    this.since_ms = now_ms();
  }

  get position_s(): number {
    const runs = !this.isPaused && !this.isHeld;
    return this.from_s + (runs ? (this.rate * (this.now_ms() - this.since_ms)) / 1000 : 0);
  }

  get paused(): boolean {
    return this.isPaused;
  }

  get speed(): number {
    return this.rate;
  }

  set(position_s: number): void {
    this.from_s = position_s;
    this.since_ms = this.now_ms();
  }

  pause(paused: boolean): void {
    this.set(this.position_s);
    this.isPaused = paused;
  }

  /** While what belongs to the position is not there yet. */
  hold(held: boolean): void {
    this.set(this.position_s);
    this.isHeld = held;
  }

  setSpeed(rate: number): void {
    this.set(this.position_s);
    this.rate = rate;
  }

  /** Milliseconds until the position is reached; infinite while it stands still. */
  until_ms(position_s: number): number {
    if (this.isPaused || this.isHeld) return Infinity;
    return Math.max(0, (1000 * (position_s - this.position_s)) / this.rate);
  }
}
