// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { insideFrame, mapFrame, stretched } from './map_frame';

test('a map shows all points with a margin, and is never tiny', () => {
  expect(mapFrame([])).toBeUndefined();
  expect(mapFrame([{ x: -3, y: 0 }, { x: 4, y: 6 }])).toEqual({ left: -4, top: -1, width: 9, height: 8 });
  expect(mapFrame([{ x: 2, y: 1 }])).toEqual({ left: 0, top: -1, width: 4, height: 4 });
});

test('a sensor at an absurd place does not shrink the room to a dot', () => {
  const frame = mapFrame([{ x: 0, y: 0 }, { x: 2, y: 2 }, { x: 9000, y: 0 }])!;
  expect(frame.width).toBeLessThan(10);
});

test('who is outside is shown at the edge', () => {
  const frame = { left: 0, top: 0, width: 4, height: 4 };
  expect(insideFrame({ x: 100, y: 1 }, frame, 0.5)).toEqual({ x: 3.5, y: 1 });
  expect(insideFrame({ x: 1, y: 1 }, frame)).toEqual({ x: 1, y: 1 });
});

test('the map is stretched for people beside the room, a metre at a time, but not for those far away', () => {
  const frame = { left: 0, top: 0, width: 4, height: 4 };
  expect(stretched(frame, [{ x: 1, y: 1 }])).toEqual(frame);
  expect(stretched(frame, [{ x: -0.2, y: 5.1 }])).toEqual({ left: -1, top: 0, width: 5, height: 6 });
  expect(stretched(frame, [{ x: -500, y: 1 }])).toEqual({ left: -4, top: 0, width: 8, height: 4 });
});
