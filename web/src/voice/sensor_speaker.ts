// SPDX-License-Identifier: Apache-2.0
// The microphones of sensors: their IDs as speakers (docs/spec/wire.md §6), and where they are.
import type { RoomSensor } from '../room_roster';
import type { PlainPose } from '../stream/protocol';

const sensorSpeakers = 0x80000000; // viewers' IDs never grow so large

export function speakerOf(sensor: number): number {
  return sensorSpeakers + sensor;
}

/** Metres, world frame; undefined: a person speaks, or a sensor that is not in the room. */
export function microphonePlace(speaker: number, sensors: readonly RoomSensor[]): PlainPose | undefined {
  const m = sensors.find(({ id }) => speakerOf(id) === speaker)?.pose.worldFromDepth;
  if (m?.length !== 16) return undefined;
  return { x: m[3]!, y: m[7]!, z: m[11]!, qx: 0, qy: 0, qz: 0, qw: 1 };
}
