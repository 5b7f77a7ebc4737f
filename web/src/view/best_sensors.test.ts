// SPDX-License-Identifier: Apache-2.0
import { Matrix4, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { bestSensors, usefulness } from './best_sensors';

/** A sensor at `position` that looks at the room's middle; x right, y down, z forward. */
function sensorAt(x: number, z: number): Matrix4 {
  const position = new Vector3(x, 1.5, z);
  const gaze = new Vector3(0, 1.5, 0).sub(position).normalize();
  const down = new Vector3(0, -1, 0);
  return new Matrix4().makeBasis(down.clone().cross(gaze), down, gaze).setPosition(position);
}

const around = new Map([
  [0, sensorAt(0, 2)],
  [1, sensorAt(2, 0)],
  [2, sensorAt(0, -2)],
  [3, sensorAt(-2, 0)],
]);

test('the sensor beside the eye is the most useful, the one that faces it the least', () => {
  const eye = new Vector3(0.2, 1.6, 2.2);
  expect([...bestSensors(around, eye, 1)]).toEqual([0]);
  expect([...bestSensors(around, eye, 3)].sort()).toEqual([0, 1, 3]);
});

test('all are drawn when there is no need to choose', () => {
  expect(bestSensors(around, new Vector3(), 8).size).toBe(4);
});

test('among sensors that look alike the nearer one is the more useful', () => {
  const eye = new Vector3(0, 1.5, 2);
  expect(usefulness(sensorAt(0, 2), eye)).toBeGreaterThan(usefulness(sensorAt(0, 4), eye));
});
