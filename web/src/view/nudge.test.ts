// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { alongView, pushed } from './nudge';

const standing = [1, 0, 0, 2, 0, -1, 0, 1.5, 0, 0, -1, 3, 0, 0, 0, 1]; // looks along -z

function expectClose(found: readonly number[], expected: readonly number[]): void {
  expected.forEach((number, i) => expect(found[i]).toBeCloseTo(number, 9));
}

describe('a push', () => {
  test('shifts along the world', () => {
    const shifted = pushed(standing, { x: 0.1, y: 0.2, z: -0.3, turn: 0 });
    expectClose([shifted[3]!, shifted[7]!, shifted[11]!], [2.1, 1.7, 2.7]);
    expectClose(shifted.slice(0, 3), [1, 0, 0]);
    expect(shifted.slice(12)).toEqual([0, 0, 0, 1]);
  });

  test('turns the sensor where it stands, counter-clockwise from above', () => {
    const turned = pushed(standing, { x: 0, y: 0, z: 0, turn: Math.PI / 2 });
    expectClose([turned[3]!, turned[7]!, turned[11]!], [2, 1.5, 3]);
    expectClose([turned[2]!, turned[6]!, turned[10]!], [-1, 0, 0]); // it looked along -z, now along -x
  });

  test('follows the view of whoever pushes', () => {
    const ahead = alongView(0, 0, 1, 0, 0);
    expectClose([ahead.x, ahead.z], [0, -1]);
    const aheadTurnedLeft = alongView(0, 0, 1, 0, Math.PI / 2);
    expectClose([aheadTurnedLeft.x, aheadTurnedLeft.z], [-1, 0]);
    const right = alongView(1, 0, 0, 0, 0);
    expectClose([right.x, right.z], [1, 0]);
  });
});
