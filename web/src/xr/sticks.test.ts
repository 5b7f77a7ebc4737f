// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { Sticks } from './sticks';

const still = { x: 0.05, y: -0.1 };

describe('thumbsticks', () => {
  test('at rest do nothing', () => {
    expect(new Sticks().read(still, still)).toEqual({ right: 0, forward: -0, turn_rad: 0, aims: false, letsGo: false });
    expect(new Sticks().read(undefined, undefined)).toMatchObject({ turn_rad: 0, aims: false });
  });

  test('the left one walks, faster the farther it is pushed', () => {
    const sticks = new Sticks();
    expect(sticks.read({ x: 0, y: -1 }, still).forward).toBe(1);
    expect(sticks.read({ x: 0, y: -0.6 }, still).forward).toBeCloseTo(0.5);
    expect(sticks.read({ x: 1, y: 0 }, still).right).toBe(1);
  });

  test('the right one turns once per push, to the right clockwise', () => {
    const sticks = new Sticks();
    expect(sticks.read(still, { x: 0.9, y: 0 }).turn_rad).toBeCloseTo(-Math.PI / 6);
    expect(sticks.read(still, { x: 0.9, y: 0 }).turn_rad).toBe(0);
    sticks.read(still, still);
    expect(sticks.read(still, { x: -0.9, y: 0 }).turn_rad).toBeCloseTo(Math.PI / 6);
  });

  test('the right one aims while it is pushed forward, and teleports when it is released', () => {
    const sticks = new Sticks();
    expect(sticks.read(still, { x: 0.5, y: -0.9 })).toMatchObject({ aims: true, letsGo: false, turn_rad: 0 });
    expect(sticks.read(still, { x: 0.9, y: -0.6 })).toMatchObject({ aims: true, turn_rad: 0 });
    expect(sticks.read(still, still)).toMatchObject({ aims: false, letsGo: true });
    expect(sticks.read(still, still)).toMatchObject({ aims: false, letsGo: false });
  });
});
