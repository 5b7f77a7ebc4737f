// SPDX-License-Identifier: Apache-2.0
// Where a viewer may go: above the floor, and not so far that the room can no longer be found. The limit follows the
// size of the room, which is known from its sensors. Pure.
import { Vector3 } from 'three';
import type { SensorPose } from '../sensor_pose';
import { lowestEye_m, maxDistance_m, pivot, type ViewState } from './view_state';

const typicalDepth_m = 2.2; // assumed distance from a sensor to the room's middle
const roomsAcross = 4; // radii of the room from its middle: there it still fills a good part of the picture
const least_m = 10;
export const most_m = 80; // within what is drawn (stage.ts)

/** A ball that the eye does not leave. */
export interface Reach {
  readonly centre: Vector3;
  readonly radius_m: number;
}

/** Without a room: around what the view looks at. */
export function reachAround(view: ViewState): Reach {
  return { centre: pivot(view), radius_m: maxDistance_m };
}

/** The middle of the sorted values: a single sensor at an absurd place does not move it. */
export function median(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[(values.length - 1) >> 1]!;
}

/** Undefined without sensors. */
export function reachOf(poses: readonly Pick<SensorPose, 'worldFromDepth'>[]): Reach | undefined {
  if (poses.length === 0) return undefined;
  const points = poses.flatMap(({ worldFromDepth: m }) => {
    const position = new Vector3(m[3], m[7], m[11]);
    return [position, new Vector3(m[2], m[6], m[10]).multiplyScalar(typicalDepth_m).add(position)];
  });
  const along = (axis: 'x' | 'y' | 'z') => median(points.map((point) => point[axis]));
  const centre = new Vector3(along('x'), along('y'), along('z'));
  const size_m = Math.max(...points.map((point) => point.distanceTo(centre)));
  return { centre, radius_m: Math.min(most_m, Math.max(least_m, roomsAcross * size_m)) };
}

/** The view with its position moved to the nearest one that is permitted. */
export function withinReach(view: ViewState, { centre, radius_m }: Reach): ViewState {
  const position = view.position.clone().sub(centre).clampLength(0, radius_m).add(centre);
  position.y = Math.max(position.y, lowestEye_m);
  return position.distanceTo(view.position) < 1e-9 ? view : { ...view, position };
}
