// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { Vector3 } from 'three';
import { alongView, pushed, standingLike } from './nudge';

const standing = [1, 0, 0, 2, 0, -1, 0, 1.5, 0, 0, -1, 3, 0, 0, 0, 1]; // looks along -z

const nothing = { right: 0, up: 0, forward: 0, turn: 0, tilt: 0 };

function expectClose(found: readonly number[], expected: readonly number[]): void {
  expected.forEach((number, i) => expect(found[i]).toBeCloseTo(number, 9));
}

describe('a nudge step', () => {
  test('shifts along the world', () => {
    const shifted = pushed(standing, { x: 0.1, y: 0.2, z: -0.3, turn: 0, tilt: 0 });
    expectClose([shifted[3]!, shifted[7]!, shifted[11]!], [2.1, 1.7, 2.7]);
    expectClose(shifted.slice(0, 3), [1, 0, 0]);
    expect(shifted.slice(12)).toEqual([0, 0, 0, 1]);
  });

  test('turns the sensor in place, counter-clockwise from above', () => {
    const turned = pushed(standing, { x: 0, y: 0, z: 0, turn: Math.PI / 2, tilt: 0 });
    expectClose([turned[3]!, turned[7]!, turned[11]!], [2, 1.5, 3]);
    expectClose([turned[2]!, turned[6]!, turned[10]!], [-1, 0, 0]); // it looked along -z, now along -x
  });

  test('tilts the sensor upwards about its own horizontal axis', () => {
    const up = pushed(standing, { x: 0, y: 0, z: 0, turn: 0, tilt: Math.PI / 6 });
    expectClose([up[2]!, up[6]!, up[10]!], [0, 0.5, -Math.cos(Math.PI / 6)]);
    expectClose([up[0]!, up[4]!, up[8]!], [1, 0, 0]);
    expectClose([up[3]!, up[7]!, up[11]!], [2, 1.5, 3]);
  });

  test('follows the user’s view', () => {
    const ahead = alongView({ ...nothing, forward: 1 }, 0);
    expectClose([ahead.x, ahead.z], [0, -1]);
    const aheadTurnedLeft = alongView({ ...nothing, forward: 1 }, Math.PI / 2);
    expectClose([aheadTurnedLeft.x, aheadTurnedLeft.z], [-1, 0]);
    const right = alongView({ ...nothing, right: 1 }, 0);
    expectClose([right.x, right.z], [1, 0]);
  });
});

test('a sensor can be put at the user’s viewpoint', () => {
  const position = new Vector3(2, 1.5, 3);
  expectClose(standingLike({ position, yaw: 0, pitch: 0 }), standing);
  const turned = standingLike({ position, yaw: Math.PI / 2, pitch: -Math.PI / 6 });
  expectClose([turned[2]!, turned[6]!, turned[10]!], [-Math.cos(Math.PI / 6), -0.5, 0]);
  const again = pushed(pushed(standing, { x: 0, y: 0, z: 0, turn: Math.PI / 2, tilt: 0 }), {
    x: 0,
    y: 0,
    z: 0,
    turn: 0,
    tilt: -Math.PI / 6,
  });
  expectClose(turned, again);
});
