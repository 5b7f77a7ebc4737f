// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { bodyOf, PosePublisher } from './pose_publisher';
import type { Body } from './stream/protocol';
import { lookFrom } from './view/view_state';

const at = (x: number) => bodyOf(lookFrom(new Vector3(x, 1.6, 0), new Vector3(x, 1.6, -1)));

test('a pose is sent when it changed, at most 20 times a second, and the last one always', () => {
  const sent: Body[] = [];
  const pose = new PosePublisher((body) => sent.push(body));
  pose.update(0, 0.7);
  expect(sent).toEqual([]);
  for (let ms = 0; ms <= 1000; ms += 10) {
    pose.moved(at(ms));
    pose.update(ms, 0.7);
  }
  expect(sent.length).toBe(21);
  pose.moved(at(5));
  pose.update(1010, 0.7);
  expect(sent.length).toBe(21);
  pose.update(1050, 0.7);
  pose.update(2000, 0.7);
  expect(sent.length).toBe(22);
  expect(sent.at(-1)!.head).toMatchObject({ x: 5, qw: 1 });
  expect(sent.at(-1)!.leftHand).toBeUndefined();
});

test('a pose is sent again when its viewer sees more or less', () => {
  const sent: Body[] = [];
  const pose = new PosePublisher((body) => sent.push(body));
  pose.update(0, 0.7);
  pose.moved(at(1));
  pose.update(100, 0.7);
  pose.update(200, 0.7);
  pose.update(300, 0);
  expect(sent.map(({ viewHalfAngle }) => viewHalfAngle)).toEqual([0.7, 0]);
});
