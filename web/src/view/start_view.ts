// SPDX-License-Identifier: Apache-2.0
// The start view. Uses the hub's start pose if there is one; otherwise computed from the sensors: at a standing
// person's eye height, on the sensors' side of the point that they look at.
import { Vector3 } from 'three';
import { isPlaced, type SensorPose } from '../sensor_pose';
import { lookFrom, type ViewState } from './view_state';

const eyeHeight_m = 1.6;
const typicalDepth_m = 2.2; // assumed distance from a sensor to the room's middle
const leastDistance_m = 2.2;
const mostDistance_m = 4;

export const fallbackView: ViewState = lookFrom(new Vector3(0, eyeHeight_m, 3), new Vector3(0, 1, 0));

type Transform = Pick<SensorPose, 'worldFromDepth'>;

function positionOf({ worldFromDepth: m }: Transform): Vector3 {
  return new Vector3(m[3], m[7], m[11]);
}

function gazeOf({ worldFromDepth: m }: Transform): Vector3 {
  return new Vector3(m[2], m[6], m[10]); // z forward
}

function mean(points: Vector3[]): Vector3 {
  return points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length);
}

/** Sensors that are not placed yet are shown next to the room; they count only if no sensor is placed. */
export function placedOrAll(poses: readonly SensorPose[]): readonly SensorPose[] {
  const placed = poses.filter(isPlaced);
  return placed.length > 0 ? placed : poses;
}

/** Undefined without sensors. */
export function startView(poses: readonly Transform[]): ViewState | undefined {
  const first = poses[0];
  if (!first) return undefined;
  const target = mean(poses.map((pose) => gazeOf(pose).multiplyScalar(typicalDepth_m).add(positionOf(pose))));
  const back = mean(poses.map(positionOf)).sub(target).setY(0);
  if (back.length() < 0.5) back.copy(positionOf(first)).sub(target).setY(0); // sensors all around: use the first one's side
  if (back.length() < 1e-3) back.set(0, 0, 1);
  const distance = Math.min(mostDistance_m, Math.max(leastDistance_m, back.length()));
  const position = back.setLength(distance).add(target).setY(eyeHeight_m);
  return lookFrom(position, target.setY(Math.min(eyeHeight_m, Math.max(0.6, target.y))));
}
