// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { isMotionKey, movedByKeys } from './motion_keys';
import { lookFrom } from './view_state';

const start = lookFrom(new Vector3(0, 1.6, 0), new Vector3(0, 1.6, -2));
const after = (...keys: string[]) => movedByKeys(start, keys, 0.5, false);

test('every direction can be reached with keys: turning, tilting, walking, rising', () => {
  expect(after('ArrowLeft').yaw).toBeCloseTo(0.6);
  expect(after('ArrowRight').yaw).toBeCloseTo(-0.6);
  expect(after('ArrowUp').pitch).toBeCloseTo(0.6);
  expect(after('ArrowDown').pitch).toBeCloseTo(-0.6);
  expect(after('ArrowLeft', 'ArrowUp').position).toEqual(start.position);
  expect(after('KeyW').position.z).toBeCloseTo(-0.7);
  expect(after('KeyD').position.x).toBeCloseTo(0.7);
  expect(after('KeyE').position.y).toBeCloseTo(2.3);
});

test('Shift is faster, opposite keys cancel out, and other keys do nothing', () => {
  expect(movedByKeys(start, ['ArrowLeft'], 0.5, true).yaw).toBeCloseTo(1.5);
  expect(after('ArrowLeft', 'ArrowRight')).toBe(start);
  expect(after()).toBe(start);
  expect(isMotionKey('KeyX')).toBe(false);
});
