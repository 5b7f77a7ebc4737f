// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { keptIn } from '../storage';
import { keepComfort, keptComfort, liftOf, narrowed } from './comfort';

const memory = () => keptIn(() => { throw new Error('blocked'); }).store;

test('the view narrows for who has chosen nothing, and choices are kept', () => {
  const store = memory();
  expect(keptComfort(store)).toEqual({ narrowsView: true, isSeated: false });
  for (const chosen of [{ narrowsView: false, isSeated: true }, { narrowsView: true, isSeated: false }]) {
    keepComfort(store, chosen);
    expect(keptComfort(store)).toEqual(chosen);
  }
});

test('what others have kept there changes nothing', () => {
  const store = memory();
  store.setItem('roomcast.comfort', '{"wide":1}');
  expect(keptComfort(store)).toEqual({ narrowsView: true, isSeated: false });
});

test('the view narrows while the wearer is moved, and widens again', () => {
  let narrow = 0;
  narrow = narrowed(narrow, true, 0.1);
  expect(narrow).toBeCloseTo(0.5);
  narrow = narrowed(narrow, true, 1);
  expect(narrow).toBe(1);
  narrow = narrowed(narrow, false, 0.1);
  expect(narrow).toBeCloseTo(0.5);
  expect(narrowed(narrow, false, 1)).toBe(0);
});

test('who sits is lifted to a standing person’s height, and nobody is lowered', () => {
  expect(liftOf(1.15)).toBeCloseTo(0.45);
  expect(liftOf(1.8)).toBe(0);
});
