// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { qualities } from '../view/quality_ladder';
import { drawingFacts } from './drawing_facts';

const all = { mode: 'blend', mixes: true, shown: 4, wanted: 4 } as const;

test('what is drawn is said in words', () => {
  expect(drawingFacts(all, qualities[0]!)).toBe('Every reading, blended, all 4 sensors.');
  expect(drawingFacts({ ...all, mixes: false, shown: 3 }, qualities.at(-1)!)).toBe(
    'Every 5th reading, the nearest surface, 3 of 4 sensors, 60 % of the screen’s resolution.',
  );
  expect(drawingFacts({ ...all, mode: 'points', mixes: false, wanted: 1, shown: 1 }, qualities[1]!)).toBe(
    'Every 2nd reading, points, the only sensor.',
  );
});

test('nothing is said before there is a picture', () => {
  expect(drawingFacts({ ...all, shown: 0, wanted: 0 }, qualities[0]!)).toBe('');
});

test('the model of the room is made of all sensors, at one fineness', () => {
  expect(drawingFacts({ ...all, mode: 'still' }, qualities[6]!)).toBe('The model of what stands still.');
});
