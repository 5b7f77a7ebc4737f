// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { startAt } from './start_places';

test('a place to enter has position, height and direction of the view, within what a hub takes', () => {
  expect(startAt({ position: new Vector3(1.234, 1.7, -2.5), yaw: Math.PI / 2 })).toEqual({ x: 1.23, z: -2.5, eye_height: 1.7, yaw_deg: 90 });
  expect(startAt({ position: new Vector3(0, 9, 0), yaw: 3 * Math.PI })).toMatchObject({ eye_height: 3 });
  expect(Math.abs(startAt({ position: new Vector3(0, 1, 0), yaw: 3 * Math.PI }).yaw_deg!)).toBe(180);
});
