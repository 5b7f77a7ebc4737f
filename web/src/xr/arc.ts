// SPDX-License-Identifier: Apache-2.0
// The arc for pointing at a place on the floor: the trajectory of a ball thrown from the hand. Metres, y up, floor at y
// = 0. Pure.
import { Vector3 } from 'three';

const speed_mPerS = 6;
const gravity_mPerS2 = 9.81;
const pieces = 32;

/** The arc's points, the last one on the floor. */
export function throwArc(from: Vector3, direction: Vector3): Vector3[] {
  const velocity = direction.clone().normalize().multiplyScalar(speed_mPerS);
  const height = Math.max(from.y, 0);
  const flight_s = (velocity.y + Math.sqrt(velocity.y ** 2 + 2 * gravity_mPerS2 * height)) / gravity_mPerS2;
  return Array.from({ length: pieces + 1 }, (_, i) => {
    const t = (flight_s * i) / pieces;
    const point = velocity.clone().multiplyScalar(t).add(from);
    point.y = height + velocity.y * t - 0.5 * gravity_mPerS2 * t * t;
    return point;
  });
}
