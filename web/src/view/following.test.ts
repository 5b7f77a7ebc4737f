// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { PoseSchema } from '../gen/control_pb';
import { bodyOf } from '../pose_publisher';
import { followed } from './following';
import { lookFrom } from './view_state';

const mine = lookFrom(new Vector3(0, 1.6, 3), new Vector3(0, 1, -1));
const theirs = lookFrom(new Vector3(2, 1.7, -1), new Vector3(0, 0.8, -2));
const head = create(PoseSchema, bodyOf(theirs).head);

test('comes to stand and look as the other one does, without a jerk, and rests there', () => {
  const first = followed(mine, head, 1 / 60, false);
  expect(first.position.distanceTo(mine.position)).toBeGreaterThan(0.2);
  expect(first.position.distanceTo(mine.position)).toBeLessThan(1);
  let view = mine;
  for (let i = 0; i < 200; i++) view = followed(view, head, 1 / 60, false);
  expect(view.position.distanceTo(theirs.position)).toBeLessThan(1e-3);
  expect(Math.sin(view.yaw - theirs.yaw)).toBeCloseTo(0, 3);
  expect(view.pitch).toBeCloseTo(theirs.pitch, 3);
  expect(followed(view, head, 1 / 60, false)).toBe(view);
});

test('is there at once for those who prefer less motion', () => {
  expect(followed(mine, head, 1 / 60, true).position.distanceTo(theirs.position)).toBeLessThan(1e-6);
});
