// SPDX-License-Identifier: Apache-2.0
// Does things later by a fixed time, in order. Without a delay it does them at once.

interface Waiting {
  due_ms: number;
  run: () => void;
}

export class LateQueue {
  private waiting: Waiting[] = [];
  private delay_ms = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly now_ms: () => number = () => performance.now()) {}

  /** What waits is done at once, so that nothing overtakes it. */
  setDelay(delay_ms: number): void {
    if (delay_ms === this.delay_ms) return;
    this.delay_ms = delay_ms;
    this.run(Infinity);
  }

  put(run: () => void): void {
    if (this.delay_ms === 0) return run();
    this.waiting.push({ due_ms: this.now_ms() + this.delay_ms, run });
    if (this.waiting.length === 1) this.wakeFor(this.waiting[0]!);
  }

  /** What waits is not done. */
  clear(): void {
    this.waiting = [];
    clearTimeout(this.timer);
  }

  private wakeFor({ due_ms }: Waiting): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.run(this.now_ms()), Math.max(0, due_ms - this.now_ms()));
  }

  private run(until_ms: number): void {
    clearTimeout(this.timer);
    const count = this.waiting.findIndex(({ due_ms }) => due_ms > until_ms);
    const due = this.waiting.splice(0, count < 0 ? this.waiting.length : count);
    due.forEach(({ run }) => run());
    if (this.waiting[0]) this.wakeFor(this.waiting[0]);
  }
}
