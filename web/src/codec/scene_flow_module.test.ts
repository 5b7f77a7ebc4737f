// SPDX-License-Identifier: Apache-2.0
import { existsSync, readFileSync } from 'node:fs';
import { beforeEach, describe, expect, test } from 'vitest';
import { flowChannels, flowSize } from './scene_flow';
import { SceneFlow, SceneFlowModule } from './scene_flow_module';

const lens = { width: 96, height: 64, fx: 90, fy: 90, cx: 47.5, cy: 31.5 };
const cells = flowSize(lens);
const step_ns = 50_000_000n;

test('cells cover the picture', () => {
  expect(flowSize({ width: 512, height: 424 })).toEqual({ width: 128, height: 106 });
  expect(flowSize({ width: 75, height: 51 })).toEqual({ width: 19, height: 13 });
});

describe.each(['roomcast_flow', 'roomcast_flow_plain'])('%s (build it with: cmake --build --preset wasm)', (name) => {
  const wasm = new URL(`../../../build/wasm/${name}.wasm`, import.meta.url);
  const built = existsSync(wasm);
  let module: SceneFlowModule;
  let flow: SceneFlow;
  let time_ns: bigint;

  beforeEach(async () => {
    if (!built) return;
    module = await SceneFlowModule.load(readFileSync(wasm));
    flow = new SceneFlow(module, lens);
    time_ns = 10n ** 18n; // a room's clock is not young
    for (let i = 0; i < 6; i++) take(undefined);
  });

  /** A board of 24x24 pixels at 1 m, or none, before a wall at 2 m. The motion in the middle of the board. */
  function take(left: number | undefined): number[] | undefined {
    const depth_mm = new Uint16Array(lens.width * lens.height).fill(2000);
    if (left !== undefined) {
      for (let y = 20; y < 44; y++) depth_mm.fill(1000, y * lens.width + left, y * lens.width + left + 24);
    }
    const field = flow.take(depth_mm, (time_ns += step_ns));
    const cell = Math.floor(32 / 4) * cells.width + Math.floor(((left ?? 0) + 12) / 4);
    return field && [...field.subarray(flowChannels * cell, flowChannels * (cell + 1))];
  }

  test.skipIf(!built)('a board that moves has its velocity', () => {
    expect(take(28)).toBeUndefined();
    const [x, y, z, limit] = take(32)!;
    expect(x).toBeCloseTo(4 / 90 / 0.05, 1);
    expect(y).toBeCloseTo(0, 1);
    expect(z).toBeCloseTo(0, 1);
    expect(limit).toBeGreaterThan(1);
    expect(limit).toBeLessThan(2);
  });

  test.skipIf(!built)('nothing moves before a wall alone, and in pictures far apart', () => {
    expect(take(undefined)).toBeUndefined();
    take(28);
    time_ns += 10n ** 9n;
    expect(take(32)).toBeUndefined();
  });

  test.skipIf(!built)('sensors do not disturb each other', () => {
    const other = new SceneFlow(module, { ...lens, width: 64 });
    take(28);
    expect(other.take(new Uint16Array(64 * lens.height).fill(500), time_ns)).toBeUndefined();
    expect(take(32)![0]).toBeCloseTo(4 / 90 / 0.05, 1);
    other.destroy();
    expect(take(36)![0]).toBeCloseTo(4 / 90 / 0.05, 1);
  });

  test.skipIf(!built)('in a picture of an impossible size nothing moves', () => {
    for (const height of [0, 5000]) {
      const impossible = new SceneFlow(module, { ...lens, height });
      expect(impossible.take(new Uint16Array(lens.width * height), time_ns)).toBeUndefined();
      impossible.destroy();
    }
  });
});
