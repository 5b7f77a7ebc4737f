// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { chartPath, readingAt, History, keptReadings, scaleOf } from './history';

test('a history keeps the newest readings only', () => {
  const history = new History();
  for (let i = 0; i < keptReadings + 5; i++) history.add(i);
  expect(history.readings.length).toBe(keptReadings);
  expect(history.readings.at(-1)).toBe(keptReadings + 4);
});

test('a chart ends at the right edge and breaks at missing readings', () => {
  const path = chartPath([1, undefined, 2, 1], 2, keptReadings - 1, 10);
  expect(path).toBe(
    `M${(keptReadings - 4).toFixed(1)} 5.0M${(keptReadings - 2).toFixed(1)} 0.0L${(keptReadings - 1).toFixed(1)} 5.0`,
  );
});

test('readings beyond the scale stay inside', () => expect(chartPath([9], 2, keptReadings - 1, 10)).toMatch(/ 0.0$/));

test('a scale is a round number that all readings fit under', () => {
  expect(scaleOf([1, 17, undefined], 5)).toBe(20);
  expect(scaleOf([], 30)).toBe(50);
  expect(scaleOf([100], 1)).toBe(100);
});

test('the reading under the mouse is found with its age', () => {
  const history = new History();
  for (let i = 0; i < keptReadings; i++) history.add(i);
  expect(readingAt(history.readings, 1)).toEqual({ value: keptReadings - 1, age_s: 0 });
  expect(readingAt(history.readings, 0)).toEqual({ value: 0, age_s: keptReadings - 1 });
  expect(readingAt([7], 0.5).value).toBeUndefined();
  expect(readingAt([7], 1.2)).toEqual({ value: 7, age_s: 0 });
});
