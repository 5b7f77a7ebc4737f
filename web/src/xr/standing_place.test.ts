// SPDX-License-Identifier: Apache-2.0
import { Quaternion, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { inWorld, movedTo, originOffset, standingOver, surfaceUnder, turned, walked, yawOf } from './standing_place';

const place = { x: 1, y: 0, z: -2, yaw: 0.7 };
const headOnFloor = new Vector3(0.3, 1.65, 0.2); // in the wearer's physical floor frame
const near = (a: Vector3, b: Vector3) => expect(a.distanceTo(b)).toBeLessThan(1e-9);

describe('the place of a wearer', () => {
  test('and the offset of its reference space undo each other', () => {
    const { position, orientation } = originOffset(place);
    near(inWorld(place, headOnFloor).applyQuaternion(orientation).add(position), headOnFloor);
  });

  test('turns about the head', () => {
    const head = inWorld(place, headOnFloor);
    const after = turned(place, head, Math.PI / 6);
    near(inWorld(after, headOnFloor), head);
    expect(after.yaw - place.yaw).toBeCloseTo(Math.PI / 6);
  });

  test('brings the head over the target', () => {
    const head = inWorld(place, headOnFloor);
    const after = movedTo(place, head, new Vector3(-1, 0, 4));
    near(inWorld(after, headOnFloor), new Vector3(-1, 1.65, 4));
  });

  test('walks in the direction of the head', () => {
    expect(walked(place, 0, 0, 1)).toMatchObject({ x: 1, z: -3 });
    expect(walked(place, Math.PI / 2, 0, 1).x).toBeCloseTo(0); // looking along -x
    expect(walked(place, 0, 1, 0)).toMatchObject({ x: 2, z: -2 });
  });

  test('gives the direction of a head', () => {
    expect(yawOf(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), 0.4))).toBeCloseTo(0.4);
  });

  test('is such that a point of the own floor or table is at a point of the room', () => {
    const table = new Vector3(0.5, 0.75, -1.2);
    const target = new Vector3(3, 0, 4);
    near(inWorld(standingOver(target, table, 1.1), table), target);
    expect(standingOver(target, table, 1.1).yaw).toBe(1.1);
  });

  test('is pointed at on the own floor, not too far away', () => {
    const from = new Vector3(0, 1.5, 0);
    near(surfaceUnder(from, new Vector3(0, -1, -1).normalize())!, new Vector3(0, 0, -1.5));
    expect(surfaceUnder(from, new Vector3(0, 0.1, -1).normalize())).toBeUndefined();
    expect(surfaceUnder(from, new Vector3(0, 0, -1))).toBeUndefined();
    expect(surfaceUnder(from, new Vector3(0, -0.01, -1).normalize())).toBeUndefined();
  });
});
