// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { bodyOf, PosePublisher } from './pose_publisher';
import type { Body } from './stream/protocol';
import { lookFrom } from './view/view_state';

const view = { halfAngle: 0.7, halfWidth: 0.6, halfHeight: 0.4 };
const at = (x: number) => bodyOf(lookFrom(new Vector3(x, 1.6, 0), new Vector3(x, 1.6, -1)));

test('a pose is sent when it changed, at most 20 times a second, and the last one always', () => {
  const sent: Body[] = [];
  const pose = new PosePublisher((body) => sent.push(body));
  pose.update(0, view);
  expect(sent).toEqual([]);
  for (let ms = 0; ms <= 1000; ms += 10) {
    pose.moved(at(ms));
    pose.update(ms, view);
  }
  expect(sent.length).toBe(21);
  pose.moved(at(5));
  pose.update(1010, view);
  expect(sent.length).toBe(21);
  pose.update(1050, view);
  pose.update(2000, view);
  expect(sent.length).toBe(22);
  expect(sent.at(-1)!.head).toMatchObject({ x: 5, qw: 1 });
  expect(sent.at(-1)!.leftHand).toBeUndefined();
});

test('a pose is sent again when its viewer sees more or less', () => {
  const sent: Body[] = [];
  const pose = new PosePublisher((body) => sent.push(body));
  pose.update(0, view);
  pose.moved(at(1));
  pose.update(100, view);
  pose.update(200, { ...view });
  pose.update(300, undefined);
  expect(sent.map((body) => body.view)).toEqual([view, undefined]);
});
