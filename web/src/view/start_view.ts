// SPDX-License-Identifier: Apache-2.0
// Where to stand first: so that the room is well seen. The hub's start pose where it gives one, else worked out from the
// sensors: at the height of a standing person's eyes, on the sensors' side of what they look at.
import { Vector3 } from 'three';
import { Placement, type SensorEntry } from '../gen/control_pb';
import { lookFrom, type ViewState } from './view_state';

const eyeHeight_m = 1.6;
const typicalDepth_m = 2.2; // how far in front of a sensor the room's middle is taken to be
const leastDistance_m = 2.2;
const mostDistance_m = 4;

export const fallbackView: ViewState = lookFrom(new Vector3(0, eyeHeight_m, 3), new Vector3(0, 1, 0));

type Posed = Pick<SensorEntry, 'worldFromDepth'>;

function positionOf({ worldFromDepth: m }: Posed): Vector3 {
  return new Vector3(m[3], m[7], m[11]);
}

function gazeOf({ worldFromDepth: m }: Posed): Vector3 {
  return new Vector3(m[2], m[6], m[10]); // z forward
}

function mean(points: Vector3[]): Vector3 {
  return points.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(points.length);
}

/** Those that nobody could place yet are shown beside the room. */
export function placedOrAll<T extends Pick<SensorEntry, 'placement'>>(sensors: readonly T[]): readonly T[] {
  const placed = sensors.filter(({ placement }) => placement !== Placement.UNPLACED);
  return placed.length > 0 ? placed : sensors;
}

/** Undefined without sensors. */
export function startView(sensors: readonly Posed[]): ViewState | undefined {
  const first = sensors[0];
  if (!first) return undefined;
  const target = mean(sensors.map((sensor) => gazeOf(sensor).multiplyScalar(typicalDepth_m).add(positionOf(sensor))));
  const back = mean(sensors.map(positionOf)).sub(target).setY(0);
  if (back.length() < 0.5) back.copy(positionOf(first)).sub(target).setY(0); // they stand all around: take one's side
  if (back.length() < 1e-3) back.set(0, 0, 1);
  const distance = Math.min(mostDistance_m, Math.max(leastDistance_m, back.length()));
  const position = back.setLength(distance).add(target).setY(eyeHeight_m);
  return lookFrom(position, target.setY(Math.min(eyeHeight_m, Math.max(0.6, target.y))));
}
