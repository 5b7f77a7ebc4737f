// SPDX-License-Identifier: Apache-2.0
// A line that a hand draws on surfaces, as sketches that a hub takes: where the hand jumps from one surface to another,
// and where a sketch would have too many points, the next one begins. Metres. Pure.
import type { Vector3 } from 'three';
import { maxMarkPoints } from '../wire/limits';

const least_m = 0.012; // between two points
const jump_m = 0.4;

export class Stroke {
  private readonly lines: Vector3[][] = [[]];

  /** False where the point is too close to the last one to matter. */
  add(point: Vector3): boolean {
    const line = this.lines.at(-1)!;
    const last = line.at(-1);
    const step_m = last?.distanceTo(point) ?? Infinity;
    if (step_m < least_m) return false;
    if (last && step_m > jump_m) this.lines.push([point]);
    else if (last && line.length === maxMarkPoints) this.lines.push([last, point]);
    else line.push(point);
    return true;
  }

  /** x, y, z of each point of each line. */
  get sketches(): number[][] {
    return this.lines.filter(({ length }) => length > 1).map((line) => line.flatMap((point) => point.toArray()));
  }
}
