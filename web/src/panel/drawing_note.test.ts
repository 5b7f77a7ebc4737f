// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { drawingNote } from './drawing_note';

const all = { mode: 'blend', mixes: true, shown: 4, wanted: 4 } as const;

test('nothing is said while everything is drawn as chosen', () => {
  expect(drawingNote(all)).toBe('');
  expect(drawingNote({ ...all, mode: 'mesh', mixes: false })).toBe('');
  expect(drawingNote({ ...all, mixes: false, shown: 0, wanted: 0 })).toBe('');
});

test('nor while somebody has chosen the quality, which is said elsewhere', () => {
  expect(drawingNote({ ...all, mixes: false, shown: 3 }, false)).toBe('');
});

test('surfaces that are not blended, and sensors that are left out, are mentioned', () => {
  expect(drawingNote({ ...all, mixes: false })).toMatch(/too slow to blend/);
  expect(drawingNote({ ...all, mixes: false, shown: 3 })).toMatch(/blend.* 3 of 4 sensors/);
  expect(drawingNote({ ...all, mode: 'points', shown: 3 })).toMatch(/^3 of 4 sensors/);
});
