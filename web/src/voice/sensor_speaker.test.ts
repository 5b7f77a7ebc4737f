// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import type { RoomSensor } from '../room_roster';
import { microphonePlace, speakerOf } from './sensor_speaker';

const worldFromDepth = [1, 0, 0, 0.5, 0, 1, 0, 1.5, 0, 0, 1, -2, 0, 0, 0, 1];
const pose = { worldFromDepth, source: 'given', state: 'valid', expectedErrorMm: 0, note: '' } as const;
const sensor: RoomSensor = { id: 3, name: 'left', online: true, fps: 30, calibration: undefined, pose };

describe('microphones of sensors', () => {
  test('are speakers with ids of their own', () => {
    expect(speakerOf(3)).toBe(0x80000003);
  });

  test('are heard from where the sensor stands', () => {
    expect(microphonePlace(speakerOf(3), [sensor])).toMatchObject({ x: 0.5, y: 1.5, z: -2 });
  });

  test('of sensors that are not there, and people, have no such place', () => {
    expect(microphonePlace(speakerOf(4), [sensor])).toBeUndefined();
    expect(microphonePlace(3, [sensor])).toBeUndefined();
  });
});
