// SPDX-License-Identifier: Apache-2.0
// Views that one does not have to walk to: a sensor's own, and the room from above. Pure.
import { Vector3 } from 'three';
import type { SensorPose } from '../sensor_pose';
import { mapFrame } from './map_frame';
import { lookFrom, maxPitch, type ViewState } from './view_state';

const typicalDepth_m = 2.2; // assumed distance from a sensor to what it looks at
const halfField = Math.tan(Math.PI / 6); // of the picture, up and down
const margin = 1.15;

type Transform = Pick<SensorPose, 'worldFromDepth'>;

function ahead({ worldFromDepth: m }: Transform): Vector3 {
  return new Vector3(m[3]! + typicalDepth_m * m[2]!, m[7]! + typicalDepth_m * m[6]!, m[11]! + typicalDepth_m * m[10]!);
}

/** From the sensor's place in its direction. */
export function viewOfSensor(pose: Transform): ViewState {
  const { worldFromDepth: m } = pose;
  return lookFrom(new Vector3(m[3], m[7], m[11]), ahead(pose));
}

/** All sensors and what they look at, with the world's -z up on the screen. Undefined without sensors. */
export function viewFromAbove(poses: readonly Transform[], aspect: number): ViewState | undefined {
  const points = poses.flatMap((pose) => [new Vector3(pose.worldFromDepth[3], 0, pose.worldFromDepth[11]), ahead(pose)]);
  const frame = mapFrame(points.map(({ x, z }) => ({ x, y: z })));
  if (!frame) return undefined;
  const height_m = (margin * Math.max(frame.height, frame.width / aspect)) / 2 / halfField;
  const position = new Vector3(frame.left + frame.width / 2, height_m, frame.top + frame.height / 2);
  return { position, yaw: 0, pitch: -maxPitch, distance: height_m };
}
