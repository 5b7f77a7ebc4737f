// SPDX-License-Identifier: Apache-2.0
import { beforeEach, describe, expect, test } from 'vitest';
import { FrameSetAssembly, type FrameSet } from './frame_set_assembly';

let sets: FrameSet<string>[];
let discarded: string[];
let assembly: FrameSetAssembly<string>;

beforeEach(() => {
  sets = [];
  discarded = [];
  assembly = new FrameSetAssembly<string>(
    (set) => sets.push(set),
    (frame) => discarded.push(frame),
  );
});

describe('a frame set', () => {
  test('is whole when its last frame is in and all are decoded', () => {
    assembly.arrive(7n, false);
    assembly.settle(7n, 'a');
    expect(sets).toEqual([]);
    assembly.arrive(7n, true);
    expect(sets).toEqual([]);
    assembly.settle(7n, 'b');
    expect(sets).toEqual([{ setId: 7n, frames: ['a', 'b'] }]);
  });

  test('is whole when the hub says that it has no more frames', () => {
    assembly.arrive(7n, false);
    assembly.close(7n);
    expect(sets).toEqual([]);
    assembly.settle(7n, 'a');
    expect(sets).toEqual([{ setId: 7n, frames: ['a'] }]);
    assembly.close(7n);
    assembly.close(8n); // of which no frame came
    expect(sets).toHaveLength(1);
  });

  test('waits for a frame that is decoded late', () => {
    assembly.arrive(7n, false);
    assembly.arrive(7n, true);
    assembly.settle(7n, 'b');
    expect(sets).toEqual([]);
    assembly.settle(7n, 'a');
    expect(sets[0]!.frames).toEqual(['b', 'a']);
  });

  test('is delivered without a frame that was given up', () => {
    assembly.arrive(7n, false);
    assembly.arrive(7n, true);
    assembly.settle(7n, undefined);
    assembly.settle(7n, 'a');
    expect(sets).toEqual([{ setId: 7n, frames: ['a'] }]);
  });

  test('without a decoded frame is not delivered', () => {
    assembly.arrive(7n, true);
    assembly.settle(7n, undefined);
    expect(sets).toEqual([]);
  });

  test('is closed by the next one when its last frame never came', () => {
    assembly.arrive(7n, false);
    assembly.settle(7n, 'a');
    assembly.arrive(8n, false);
    assembly.settle(8n, 'b');
    expect(sets).toEqual([{ setId: 7n, frames: ['a'] }]);
  });

  test('is not overtaken by the next one', () => {
    assembly.arrive(7n, false);
    assembly.arrive(7n, true);
    assembly.settle(7n, 'a7');
    assembly.arrive(8n, true);
    assembly.settle(8n, 'a8');
    expect(sets).toEqual([]);
    assembly.settle(7n, 'b7');
    expect(sets.map((set) => set.frames)).toEqual([['a7', 'b7'], ['a8']]);
  });

  test('that delays four others is delivered incomplete, and its late frames are discarded', () => {
    for (const set of [1n, 2n, 3n, 4n, 5n]) {
      assembly.arrive(set, false);
      assembly.arrive(set, true);
      assembly.settle(set, `a${set}`);
    }
    expect(sets).toEqual([{ setId: 1n, frames: ['a1'] }]);
    assembly.settle(1n, 'b1');
    expect(discarded).toEqual(['b1']);
  });

  test('is forgotten when the connection goes', () => {
    assembly.arrive(7n, false);
    assembly.arrive(7n, true);
    assembly.settle(7n, 'a');
    assembly.clear();
    assembly.settle(7n, 'b');
    expect(discarded).toEqual(['a', 'b']);
    expect(sets).toEqual([]);
  });
});
