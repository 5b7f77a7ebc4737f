// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { expect, test } from 'vitest';
import { Placement, SensorEntrySchema } from './gen/control_pb';
import { isPlaced, poseOf } from './sensor_pose';

const { UNPLACED, GIVEN, ALIGNED } = Placement;
const poseFrom = (fields: object) => poseOf(create(SensorEntrySchema, fields));

test.each([
  [{ placement: UNPLACED }, 'none', 'none'],
  [{ placement: UNPLACED, moved: true }, 'none', 'moved'],
  [{ placement: GIVEN }, 'given', 'valid'],
  [{ placement: GIVEN, moved: true }, 'given', 'moved'],
  [{ placement: ALIGNED }, 'estimated', 'valid'],
  [{ placement: ALIGNED, moved: true }, 'estimated', 'moved'],
  [{ placement: ALIGNED, unverified: true }, 'stored', 'unverified'],
  [{ placement: ALIGNED, unverified: true, moved: true }, 'stored', 'moved'],
])('%o has the source %s and the state %s', (fields, source, state) => {
  expect(poseFrom(fields)).toMatchObject({ source, state });
  expect(isPlaced(poseFrom(fields))).toBe(source !== 'none');
});

test('only an estimated pose has an expected error', () => {
  expect(poseFrom({ placement: ALIGNED, expectedErrorMm: 4 }).expectedErrorMm).toBe(4);
  expect(poseFrom({ placement: GIVEN, expectedErrorMm: 4 }).expectedErrorMm).toBe(0);
});
