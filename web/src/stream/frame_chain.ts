// SPDX-License-Identifier: Apache-2.0
// Decides which frames of one sensor may be decoded: a key frame, or a frame whose base_seq is the last decoded layer-0
// frame. docs/spec/wire.md §2.
import type { FrameHeader } from '../wire/frame_header';

type ChainFields = Pick<FrameHeader, 'key' | 'layer' | 'seq' | 'baseSeq'>;

export class FrameChain {
  private newestBase: number | undefined;

  /** False at first and after `lose`: then only a key frame can be decoded. */
  get inStep(): boolean {
    return this.newestBase !== undefined;
  }

  mayDecode(frame: ChainFields): boolean {
    return frame.key || (this.newestBase !== undefined && frame.baseSeq === this.newestBase);
  }

  /** The frame was decoded, or submitted to a decoder that keeps the order. */
  advance(frame: ChainFields): void {
    if (frame.key || frame.layer === 0) this.newestBase = frame.seq;
  }

  /** The decoder lost its state. */
  lose(): void {
    this.newestBase = undefined;
  }
}
