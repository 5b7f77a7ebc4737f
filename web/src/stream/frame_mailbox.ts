// SPDX-License-Identifier: Apache-2.0
// Between decoding and drawing: at most one set is with the page; while it draws, newer frames wait here, per sensor only
// the newest. So a slow page skips frames and never falls behind.

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

  /** The page has drawn what it was sent. */
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
