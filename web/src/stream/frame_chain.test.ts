// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { FrameChain } from './frame_chain';

const key = (seq: number) => ({ key: true, layer: 0, seq, baseSeq: seq });
const base = (seq: number, baseSeq: number) => ({ key: false, layer: 0, seq, baseSeq });
const droppable = (seq: number, baseSeq: number) => ({ key: false, layer: 1, seq, baseSeq });

/** Sequence numbers decoded by a viewer that receives exactly `frames`. */
function decoded(frames: ReturnType<typeof key>[]): number[] {
  const chain = new FrameChain();
  return frames.flatMap((frame) => {
    if (!chain.mayDecode(frame)) return [];
    chain.advance(frame);
    return [frame.seq];
  });
}

describe('a frame chain', () => {
  test('begins with a key frame and nothing else', () => {
    expect(decoded([base(1, 0), droppable(2, 1), key(3), droppable(4, 3)])).toEqual([3, 4]);
  });
  test('goes from base to base, droppable frames in between may be missing', () => {
    expect(decoded([key(0), droppable(1, 0), base(2, 0), base(4, 2), droppable(5, 4)])).toEqual([0, 1, 2, 4, 5]);
  });
  test('stops where a base frame is missing, until the next key frame', () => {
    expect(decoded([key(0), droppable(3, 2), base(4, 2), droppable(5, 4), key(6), base(8, 6)])).toEqual([0, 6, 8]);
  });
  test('refuses a frame with an older base than the newest', () => {
    expect(decoded([key(0), base(2, 0), droppable(3, 0)])).toEqual([0, 2]);
  });
  test('goes on where the sequence number wraps', () => {
    expect(decoded([key(0xfffffffe), base(0, 0xfffffffe), base(2, 0)])).toEqual([0xfffffffe, 0, 2]);
  });
  test('that was lost needs a key frame', () => {
    const chain = new FrameChain();
    chain.advance(key(0));
    expect(chain.inStep).toBe(true);
    chain.lose();
    expect(chain.inStep).toBe(false);
    expect(chain.mayDecode(base(2, 0))).toBe(false);
    expect(chain.mayDecode(key(3))).toBe(true);
  });
});
