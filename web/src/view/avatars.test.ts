// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { Sprite, Vector3 } from 'three';
import { afterEach, expect, test, vi } from 'vitest';
import { ViewerEntrySchema, ViewerPoseSchema } from '../gen/control_pb';
import { Avatars } from './avatars';

/** A browser's canvas, as far as labels need it. */
function stubCanvas(): void {
  const paint = new Proxy({}, { get: () => () => ({ width: 10 }), set: () => true });
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => paint }) });
}

afterEach(() => vi.unstubAllGlobals());

test('somebody who stands where the eye is does not hide the room', () => {
  stubCanvas();
  const avatars = new Avatars();
  avatars.follow([create(ViewerEntrySchema, { id: 2 }), create(ViewerEntrySchema, { id: 3 })]);
  const at = (viewerId: number, z: number) => create(ViewerPoseSchema, { viewerId, head: { y: 1.6, z, qw: 1 } });
  avatars.move([at(2, 0.1), at(3, -1.5)]);
  const people = avatars.root.children.filter((child) => child.type === 'Group');
  const drawn = () => people.map(({ children: [body] }) => body!.visible);
  avatars.hideAt(new Vector3(0, 1.6, 0));
  expect(drawn()).toEqual([false, true]);
  avatars.hideAt(new Vector3(0, 1.6, 1));
  expect(drawn()).toEqual([true, true]);
});

test('somebody who points has a beam with a spot and the name there, also where they themselves are not drawn', () => {
  stubCanvas();
  const avatars = new Avatars();
  avatars.follow([create(ViewerEntrySchema, { id: 2, name: 'Ada', colorRgb: 0xe69f00 })]);
  const beam = avatars.root.children.find((child) => child.type === 'Group')!.children[1]!;
  const pose = { viewerId: 2, head: { y: 1.6, qw: 1 } };
  const pointer = { from: { y: 1.4 }, to: { y: 1.4, z: -2 } };
  avatars.move([create(ViewerPoseSchema, { ...pose, pointer })]);
  avatars.hideAt(new Vector3(0, 1.6, 0));
  expect(beam.visible).toBe(true);
  const spot = beam.children[1]!.getWorldPosition(new Vector3());
  expect(spot.distanceTo(new Vector3(0, 1.4, -2))).toBeLessThan(1e-6);
  const label = beam.children[1]!.children[0]!;
  expect(label.type).toBe('Sprite');
  expect(label.getWorldPosition(new Vector3()).distanceTo(spot)).toBeCloseTo(0.09);
  avatars.move([create(ViewerPoseSchema, pose)]);
  expect(beam.visible).toBe(false);
});

test('the name of somebody who speaks is larger and of another colour until they pause', () => {
  stubCanvas();
  const avatars = new Avatars();
  avatars.follow([create(ViewerEntrySchema, { id: 2 }), create(ViewerEntrySchema, { id: 3 })]);
  const labels: Sprite[] = [];
  avatars.root.traverse((object) => object instanceof Sprite && labels.push(object));
  const usual = labels[0]!.scale.x;
  expect(avatars.speak(new Set([2]))).toBe(true);
  expect(avatars.speak(new Set([2]))).toBe(false);
  const louder = labels.filter(({ scale }) => scale.x > usual);
  expect(louder.length).toBe(1);
  expect(louder[0]!.material.color.getHex()).not.toBe(0xffffff);
  expect(avatars.speak(new Set())).toBe(true);
  expect(labels.every(({ scale, material }) => scale.x === usual && material.color.getHex() === 0xffffff)).toBe(true);
});
