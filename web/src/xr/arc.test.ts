// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { throwArc } from './arc';

const hand = new Vector3(1, 1.2, 2);

test('an arc leads from the hand to the floor ahead of it', () => {
  const arc = throwArc(hand, new Vector3(0, 0, -1));
  expect(arc[0]).toEqual(hand);
  const end = arc.at(-1)!;
  expect(end.y).toBeCloseTo(0);
  expect(end.x).toBeCloseTo(1);
  expect(end.z).toBeCloseTo(2 - 6 * Math.sqrt((2 * 1.2) / 9.81));
});

test('pointing higher leads farther, pointing straight down to the feet', () => {
  const level = throwArc(hand, new Vector3(0, 0, -1)).at(-1)!;
  const raised = throwArc(hand, new Vector3(0, 0.5, -1)).at(-1)!;
  expect(raised.z).toBeLessThan(level.z);
  expect(
    throwArc(hand, new Vector3(0, -1, 0))
      .at(-1)!
      .distanceTo(new Vector3(1, 0, 2)),
  ).toBeLessThan(1e-6);
});
