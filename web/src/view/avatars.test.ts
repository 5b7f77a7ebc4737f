// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { Vector3 } from 'three';
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
  const drawn = () => avatars.root.children.filter((child) => child.type === 'Group').map(({ visible }) => visible);
  avatars.hideAt(new Vector3(0, 1.6, 0));
  expect(drawn()).toEqual([false, true]);
  avatars.hideAt(new Vector3(0, 1.6, 1));
  expect(drawn()).toEqual([true, true]);
});
