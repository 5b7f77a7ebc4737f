// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { gazeOf, turnBetween } from './device_turn';

const upright = 90; // beta of a phone held before one's eyes

describe('a phone', () => {
  test('held upright looks ahead, and turns to the left with growing alpha', () => {
    const ahead = gazeOf(0, upright, 0, 0);
    expect(ahead.pitch).toBeCloseTo(0);
    const left = gazeOf(30, upright, 0, 0);
    expect(turnBetween(ahead, left).yaw).toBeCloseTo(Math.PI / 6);
    expect(left.pitch).toBeCloseTo(0);
  });

  test('tilted back looks up', () => {
    expect(gazeOf(0, upright + 20, 0, 0).pitch).toBeCloseTo((20 * Math.PI) / 180);
    expect(gazeOf(0, upright - 20, 0, 0).pitch).toBeCloseTo((-20 * Math.PI) / 180);
  });

  test('that lies on the table looks down', () => {
    expect(gazeOf(70, 0, 0, 0).pitch).toBeCloseTo(-Math.PI / 2);
  });

  test('held across looks where its back does, too', () => {
    const ahead = gazeOf(0, 0, -90, 90);
    expect(ahead.pitch).toBeCloseTo(0);
    expect(turnBetween(ahead, gazeOf(25, 0, -90, 90)).yaw).toBeCloseTo((25 * Math.PI) / 180);
  });

  test('turned beyond north turns on', () => {
    const { yaw } = turnBetween(gazeOf(350, upright, 0, 0), gazeOf(10, upright, 0, 0));
    expect(yaw).toBeCloseTo((20 * Math.PI) / 180);
  });
});
