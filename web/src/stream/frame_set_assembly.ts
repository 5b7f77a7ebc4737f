// SPDX-License-Identifier: Apache-2.0
// Puts frames, whose decoding may finish out of order, back into the sets sent by the hub. A set is complete when its
// `last` frame has arrived and every frame is either decoded or given up. Sets are delivered in order; a set that
// delays too many others is delivered incomplete.

export interface FrameSet<Frame> {
  setId: bigint;
  frames: Frame[];
}

interface OpenSet<Frame> extends FrameSet<Frame> {
  pending: number; // frames that arrived and are neither decoded nor given up
  closed: boolean; // the last frame has arrived
}

/** Decoders run a few frames behind at most. */
const maxOpenSets = 4;

export class FrameSetAssembly<Frame> {
  private readonly open = new Map<bigint, OpenSet<Frame>>(); // in order of arrival

  constructor(
    private readonly deliver: (set: FrameSet<Frame>) => void,
    private readonly discard: (frame: Frame) => void,
  ) {}

  /** A frame of this set has arrived. Exactly one `settle` must follow. */
  arrive(setId: bigint, last: boolean): void {
    const set = this.open.get(setId) ?? this.begin(setId);
    set.pending++;
    if (last) set.closed = true;
  }

  /** No more frames of this set will arrive. */
  close(setId: bigint): void {
    const set = this.open.get(setId);
    if (!set) return;
    set.closed = true;
    this.deliverWhole();
  }

  /** The frame is decoded, or (undefined) given up. */
  settle(setId: bigint, frame: Frame | undefined): void {
    const set = this.open.get(setId);
    if (!set) {
      if (frame !== undefined) this.discard(frame);
      return;
    }
    set.pending--;
    if (frame !== undefined) set.frames.push(frame);
    this.deliverWhole();
  }

  /** Discards all sets after the connection is lost. */
  clear(): void {
    for (const set of this.open.values()) set.frames.forEach(this.discard);
    this.open.clear();
  }

  private begin(setId: bigint): OpenSet<Frame> {
    for (const earlier of this.open.values()) earlier.closed = true;
    const set = { setId, frames: [], pending: 0, closed: false };
    this.open.set(setId, set);
    this.deliverWhole();
    return set;
  }

  private deliverWhole(): void {
    for (const set of this.open.values()) {
      const whole = set.closed && set.pending === 0;
      if (!whole && this.open.size <= maxOpenSets) return;
      this.open.delete(set.setId);
      if (set.frames.length > 0) this.deliver({ setId: set.setId, frames: set.frames });
    }
  }
}
