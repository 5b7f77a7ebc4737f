// SPDX-License-Identifier: Apache-2.0
// The module's motion, from depth that is written where the decoder has it.
import { existsSync, readFileSync } from 'node:fs';
import { beforeEach, describe, expect, test } from 'vitest';
import { CodecModule } from './codec_module';
import { flowChannels, flowSize } from './scene_flow';

const wasm = new URL('../../../build/wasm/roomcast_codec.wasm', import.meta.url);
const lens = { width: 96, height: 64, fx: 90, fy: 90, cx: 47.5, cy: 31.5 };
const cells = flowSize(lens);
const step_us = 50_000;

test('cells cover the picture', () => {
  expect(flowSize({ width: 512, height: 424 })).toEqual({ width: 128, height: 106 });
  expect(flowSize({ width: 75, height: 51 })).toEqual({ width: 19, height: 13 });
});

describe.skipIf(!existsSync(wasm))('the module (build it with: cmake --build --preset wasm)', () => {
  let codec: CodecModule['exports'];
  let flow: number;
  let decoder: number;
  let time_us: number;

  beforeEach(async () => {
    codec = (await CodecModule.load(readFileSync(wasm))).exports;
    flow = codec.flow_create(lens.width, lens.height, lens.fx, lens.fy, lens.cx, lens.cy);
    decoder = codec.decoder_create(lens.width, lens.height);
    time_us = 1e15; // a room's clock is not young
    for (let i = 0; i < 6; i++) take(undefined);
  });

  /** A board of 24x24 pixels at 1 m, or none, before a wall at 2 m. The motion in the middle of the board. */
  function take(left: number | undefined): number[] | undefined {
    const address = codec.decoder_depth(decoder);
    const depth = new Uint16Array(codec.memory.buffer, address, lens.width * lens.height).fill(2000);
    if (left !== undefined) for (let y = 20; y < 44; y++) depth.fill(1000, y * lens.width + left, y * lens.width + left + 24);
    const at = codec.flow_take(flow, address, (time_us += step_us));
    if (at === 0) return undefined;
    const field = new Float32Array(codec.memory.buffer, at, flowChannels * cells.width * cells.height);
    const cell = Math.floor(32 / 4) * cells.width + Math.floor(((left ?? 0) + 12) / 4);
    return [...field.subarray(flowChannels * cell, flowChannels * (cell + 1))];
  }

  test('a board that moves has its velocity', () => {
    expect(take(28)).toBeUndefined();
    const [x, y, z, limit] = take(32)!;
    expect(x).toBeCloseTo(4 / 90 / 0.05, 1);
    expect(y).toBeCloseTo(0, 1);
    expect(z).toBeCloseTo(0, 1);
    expect(limit).toBeGreaterThan(1);
    expect(limit).toBeLessThan(2);
  });

  test('nothing moves before a wall alone, and in pictures far apart', () => {
    expect(take(undefined)).toBeUndefined();
    take(28);
    time_us += 1e6;
    expect(take(32)).toBeUndefined();
  });

  test('a picture of an impossible size is refused', () => {
    expect(codec.flow_create(0, 64, 90, 90, 47, 31)).toBe(0);
    expect(codec.flow_create(96, 5000, 90, 90, 47, 31)).toBe(0);
  });
});
