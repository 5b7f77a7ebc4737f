// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { SetPace } from './set_pace';

/** How many sets of ten seconds are let through. */
function taken(fps: number, ofFps: number): number {
  const pace = new SetPace();
  pace.set(fps);
  let count = 0;
  for (let i = 0; i < 10 * ofFps; i++) if (pace.takes((1000 * i) / ofFps)) count++;
  return count;
}

describe('the pace of sets', () => {
  test('lets all through without a limit', () => expect(taken(0, 30)).toBe(300));
  test('keeps a rate that is no part of the other', () => {
    expect(taken(10, 30)).toBe(100);
    expect(Math.abs(taken(12, 30) - 120)).toBeLessThan(25);
    expect(Math.abs(taken(7, 30) - 70)).toBeLessThan(3);
  });
  test('lets no more through than there are', () => expect(taken(60, 30)).toBe(300));
});
