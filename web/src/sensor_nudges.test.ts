// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { expect, test } from 'vitest';
import { RosterSchema } from './gen/control_pb';
import { roomRoster } from './room_roster';
import { SensorNudges } from './sensor_nudges';

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const rosterOf = (...sensors: object[]) => roomRoster(create(RosterSchema, { sensors }));
const s0 = { id: 0, worldFromDepth: identity };
const right = { x: 1, y: 0, z: 0, turn: 0, tilt: 0 };

test('steps add up, and only the moved sensor differs from the roster', () => {
  const nudges = new SensorNudges();
  const roster = rosterOf(s0, { id: 1, worldFromDepth: identity });
  nudges.push(roster.sensors[0]!, right);
  nudges.push(roster.sensors[0]!, right);
  const shown = nudges.applyTo(roster).sensors;
  expect(shown[0]!.pose.worldFromDepth[3]).toBe(2);
  expect(shown[1]!.pose.worldFromDepth).toEqual(identity);
  nudges.forget(0);
  expect(nudges.applyTo(roster).sensors[0]!.pose.worldFromDepth).toEqual(identity);
});

test('a nudge lasts until the aligner has answered', () => {
  const nudges = new SensorNudges();
  const before = rosterOf(s0);
  nudges.push(before.sensors[0]!, right);
  nudges.forgetAnswered(before, rosterOf({ ...s0, online: true }));
  expect(nudges.of(0)).toBeDefined();
  nudges.forgetAnswered(before, rosterOf({ ...s0, placementNote: 'nothing matches there' }));
  expect(nudges.of(0)).toBeUndefined();
});
