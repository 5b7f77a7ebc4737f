// SPDX-License-Identifier: Apache-2.0
// Which frames of one sensor may be decoded: a key frame, or one whose base_seq is the newest layer-0 frame that was
// decoded. docs/spec/wire.md §2.
import type { FrameHeader } from '../wire/frame_header';

type ChainFields = Pick<FrameHeader, 'key' | 'layer' | 'seq' | 'baseSeq'>;

export class FrameChain {
  private newestBase: number | undefined;

  /** False in the beginning and after `lose`: only a key frame helps then. */
  get inStep(): boolean {
    return this.newestBase !== undefined;
  }

  mayDecode(frame: ChainFields): boolean {
    return frame.key || (this.newestBase !== undefined && frame.baseSeq === this.newestBase);
  }

  /** The frame has been decoded, or is on its way through a decoder that keeps order. */
  advance(frame: ChainFields): void {
    if (frame.key || frame.layer === 0) this.newestBase = frame.seq;
  }

  /** The decoder has lost its state. */
  lose(): void {
    this.newestBase = undefined;
  }
}
