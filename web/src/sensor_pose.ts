// SPDX-License-Identifier: Apache-2.0
// A sensor's pose in the room, its source and its state, with the same fields as SensorPose in the C++ code
// (roomcast/geometry/sensor_pose.h).
import { Placement, type SensorEntry } from './gen/control_pb';

export type PoseSource = 'none' | 'given' | 'estimated' | 'stored';
export type PoseState = 'none' | 'valid' | 'unverified' | 'moved';

export interface SensorPose {
  worldFromDepth: number[]; // row-major 4x4, metres; without a source: a placeholder for display
  source: PoseSource;
  state: PoseState;
  expectedErrorMm: number; // of an estimated pose; 0: unknown
  note: string; // why alignment could not place the sensor
}

function sourceOf({ placement, unverified }: SensorEntry): PoseSource {
  if (placement === Placement.GIVEN) return 'given';
  if (placement !== Placement.ALIGNED) return 'none';
  return unverified ? 'stored' : 'estimated';
}

function stateOf(source: PoseSource): PoseState {
  if (source === 'none') return 'none';
  return source === 'stored' ? 'unverified' : 'valid';
}

export function poseOf(entry: SensorEntry): SensorPose {
  const source = sourceOf(entry);
  return {
    worldFromDepth: entry.worldFromDepth,
    source,
    state: entry.moved ? 'moved' : stateOf(source),
    expectedErrorMm: source === 'estimated' || source === 'stored' ? entry.expectedErrorMm : 0,
    note: entry.placementNote,
  };
}

export function isPlaced({ source }: SensorPose): boolean {
  return source !== 'none';
}

/** False where the hub keeps the pose that the sensor supplied, whatever a user proposes: hub/room/pose_rules. */
export function mayBeProposed({ source, state }: SensorPose): boolean {
  return source !== 'given' || state === 'moved';
}
