// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { expect, test } from 'vitest';
import { RosterSchema, type Roster } from './gen/control_pb';
import { SensorGuesses } from './sensor_guesses';

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const rosterOf = (...sensors: object[]): Roster => create(RosterSchema, { sensors });
const s0 = { id: 0, worldFromDepth: identity };
const right = { x: 1, y: 0, z: 0, turn: 0, tilt: 0 };

test('pushes add up, and only the sensor that is moved differs from the roster', () => {
  const guesses = new SensorGuesses();
  const roster = rosterOf(s0, { id: 1, worldFromDepth: identity });
  guesses.push(roster.sensors[0]!, right);
  guesses.push(roster.sensors[0]!, right);
  const shown = guesses.applyTo(roster).sensors;
  expect(shown[0]!.worldFromDepth[3]).toBe(2);
  expect(shown[1]!.worldFromDepth).toEqual(identity);
  guesses.forget(0);
  expect(guesses.applyTo(roster).sensors[0]!.worldFromDepth).toEqual(identity);
});

test('a guess lasts until the aligner has answered', () => {
  const guesses = new SensorGuesses();
  const before = rosterOf(s0);
  guesses.push(before.sensors[0]!, right);
  guesses.forgetAnswered(before, rosterOf({ ...s0, online: true }));
  expect(guesses.of(0)).toBeDefined();
  guesses.forgetAnswered(before, rosterOf({ ...s0, placementNote: 'nothing matches there' }));
  expect(guesses.of(0)).toBeUndefined();
});
