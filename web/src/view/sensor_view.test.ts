// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { viewFromAbove, viewOfSensor } from './sensor_view';
import { direction, pivot } from './view_state';

/** At x, z, 2 m high, looking along +z. */
const sensorAt = (x: number, z: number) => ({ worldFromDepth: [-1, 0, 0, x, 0, -1, 0, 2, 0, 0, 1, z, 0, 0, 0, 1] });

test('a sensor’s own view is from its place in its direction', () => {
  const view = viewOfSensor(sensorAt(1, -3));
  expect(view.position).toEqual(new Vector3(1, 2, -3));
  expect(direction(view).distanceTo(new Vector3(0, 0, 1))).toBeLessThan(1e-9);
});

test('from above one sees all sensors, also on a narrow screen', () => {
  const wide = viewFromAbove([sensorAt(-4, -2), sensorAt(4, -2)], 1.6)!;
  const narrow = viewFromAbove([sensorAt(-4, -2), sensorAt(4, -2)], 0.5)!;
  expect([wide.position.x, wide.yaw]).toEqual([0, 0]);
  expect(Math.abs(pivot(wide).y)).toBeLessThan(0.1);
  const seen_m = (height: number, aspect: number) => 2 * height * Math.tan(Math.PI / 6) * aspect;
  expect(seen_m(wide.position.y, 1.6)).toBeGreaterThan(9);
  expect(seen_m(narrow.position.y, 0.5)).toBeGreaterThan(9);
  expect(viewFromAbove([], 1)).toBeUndefined();
});
