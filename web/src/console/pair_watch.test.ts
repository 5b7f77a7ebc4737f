// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import type { RoomSensor } from '../room_roster';
import type { ViewFrame } from '../stream/protocol';
import { PairWatch } from './pair_watch';

const depth = { width: 120, height: 90, fx: 100, fy: 100, cx: 59.5, cy: 44.5, k1: 0, k2: 0, k3: 0, p1: 0, p2: 0 };
const entryAt = (id: number, x: number, online = true) =>
  ({
    id,
    online,
    calibration: { depth },
    pose: { worldFromDepth: [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] },
  }) as RoomSensor;
const frameOf = (sensor: number, wall_mm: number) =>
  ({ sensor, depth_mm: new Uint16Array(depth.width * depth.height).fill(wall_mm) }) as unknown as ViewFrame;

test('pairs are compared one after the other, and a sensor that is gone is forgotten', () => {
  const watch = new PairWatch();
  const three = [entryAt(0, 0), entryAt(1, 0.2), entryAt(2, 0.4)];
  watch.step(three); // registers the sensors; none has sent a frame yet
  watch.offer([frameOf(0, 2000), frameOf(1, 2010), frameOf(2, 2030)], 0);
  expect(watch.pairs).toEqual([]);
  for (let i = 0; i < 3; i++) watch.step(three);
  const gaps = watch.pairs.map(({ a, b, gap_mm }) => [a, b, Math.round(gap_mm)]);
  expect(gaps.sort()).toEqual([
    [0, 1, 10],
    [0, 2, 30],
    [1, 2, 20],
  ]);
  watch.step([entryAt(0, 0), entryAt(1, 0.2), entryAt(2, 0.4, false)]);
  expect(watch.pairs.map(({ a, b }) => [a, b])).toEqual([[0, 1]]);
});

test('depth is copied now and then only', () => {
  const watch = new PairWatch();
  const two = [entryAt(0, 0), entryAt(1, 0.2)];
  watch.step(two);
  watch.offer([frameOf(0, 2000), frameOf(1, 2010)], 0);
  watch.offer([frameOf(1, 2050)], 100);
  watch.step(two);
  expect(Math.round(watch.pairs[0]!.gap_mm)).toBe(10);
  watch.offer([frameOf(1, 2050)], 5000);
  watch.step(two);
  expect(Math.round(watch.pairs[0]!.gap_mm)).toBe(50);
});
