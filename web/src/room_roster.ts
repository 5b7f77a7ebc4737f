// SPDX-License-Identifier: Apache-2.0
// The sensors and people of the room as the page knows them, from the hub's roster.
import type { Calibration, Roster, ViewerEntry } from './gen/control_pb';
import { poseOf, type SensorPose } from './sensor_pose';

export interface RoomSensor {
  id: number;
  name: string;
  online: boolean;
  fps: number;
  calibration: Calibration | undefined;
  pose: SensorPose;
}

export interface RoomRoster {
  sensors: RoomSensor[];
  viewers: ViewerEntry[];
}

export function roomRoster(roster: Roster): RoomRoster {
  const sensors = roster.sensors.map((entry) => {
    const { id, name, online, fps, calibration } = entry;
    return { id, name, online, fps, calibration, pose: poseOf(entry) };
  });
  return { sensors, viewers: roster.viewers };
}
