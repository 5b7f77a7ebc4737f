// SPDX-License-Identifier: Apache-2.0
// Mailbox between decoding and drawing. The page draws at most one set at a time; meanwhile newer frames wait here,
// only the newest per sensor. A slow page therefore skips frames and never falls behind.

interface SensorFrame {
  sensor: number;
}

export class FrameMailbox<Frame extends SensorFrame> {
  private readonly waiting = new Map<number, Frame>();
  private newestSet = 0n;
  private pageIsBusy = false;

  constructor(
    private readonly send: (setId: bigint, frames: Frame[]) => void,
    private readonly discard: (frame: Frame) => void,
  ) {}

  put(setId: bigint, frames: Frame[]): void {
    for (const frame of frames) {
      const older = this.waiting.get(frame.sensor);
      if (older) this.discard(older);
      this.waiting.set(frame.sensor, frame);
    }
    this.newestSet = setId;
    this.sendIfFree();
  }

  /** Discards what waits. */
  clear(): void {
    for (const frame of this.waiting.values()) this.discard(frame);
    this.waiting.clear();
  }

  /** The page has drawn the last set. */
  pageIsFree(): void {
    this.pageIsBusy = false;
    this.sendIfFree();
  }

  private sendIfFree(): void {
    if (this.pageIsBusy || this.waiting.size === 0) return;
    this.pageIsBusy = true;
    const frames = [...this.waiting.values()];
    this.waiting.clear();
    this.send(this.newestSet, frames);
  }
}
