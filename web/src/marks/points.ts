// SPDX-License-Identifier: Apache-2.0
// The points of a mark. Metres, world. Pure.
import { Vector3 } from 'three';
import type { Mark } from '../gen/control_pb';

export function pointsOf({ points }: Pick<Mark, 'points'>): Vector3[] {
  return Array.from({ length: points.length / 3 }, (_, i) => new Vector3().fromArray(points, 3 * i));
}
