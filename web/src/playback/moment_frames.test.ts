// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import type { FrameHeader } from '../wire/frame_header';
import { inOrderOfShowing } from './moment_frames';

const frame = (sensor: number, seq: number) => ({
  header: { sensor, seq, setId: 9n, last: false, key: seq === 0 } as FrameHeader,
  payload: new Uint8Array(),
});

describe('the frames of a moment', () => {
  test('are shown first and last for each sensor, each as a whole set, and decoded in their order', () => {
    const frames = [frame(0, 0), frame(1, 0), frame(0, 1), frame(1, 1), frame(0, 2), frame(0, 3)];
    const ordered = inOrderOfShowing(frames, -4n).map(({ header, isShown }) => {
      return [header.sensor, header.seq, isShown ? header.setId : undefined, header.last];
    });
    expect(ordered).toEqual([
      [0, 0, -4n, false],
      [1, 0, -4n, true],
      [0, 1, undefined, false],
      [0, 2, undefined, false],
      [0, 3, -3n, false],
      [1, 1, -3n, true],
    ]);
  });

  test('of which there is one are shown once', () => {
    expect(inOrderOfShowing([frame(3, 0)], 0n).map(({ header }) => header.last)).toEqual([true]);
    expect(inOrderOfShowing([], 0n)).toEqual([]);
  });
});
