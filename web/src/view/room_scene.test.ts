// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import type { WebGLRenderer } from 'three';
import { expect, test } from 'vitest';
import { RosterSchema } from '../gen/control_pb';
import { roomRoster } from '../room_roster';
import { RoomScene } from './room_scene';

const depth = { width: 4, height: 3, fx: 4, fy: 4, cx: 1.5, cy: 1 };
const rosterOf = (...names: string[]) =>
  roomRoster(create(RosterSchema, { sensors: names.map((name, id) => ({ id, name, calibration: { depth } })) }));

test('a hidden sensor stays hidden when the hub numbers its sensors anew, or it comes back later', () => {
  const room = new RoomScene({ extensions: { has: () => false } } as unknown as WebGLRenderer);
  const hiddenOnes = () => [...room.placed.values()].filter(({ wanted }) => !wanted).map(({ entry }) => entry.name);
  room.follow(rosterOf('s0', 's1'), -1);
  room.setVisible('s0', false);
  expect(hiddenOnes()).toEqual(['s0']);
  room.follow(rosterOf('s1', 's0'), -1);
  expect(hiddenOnes()).toEqual(['s0']);
  room.follow(rosterOf('s1'), -1);
  room.follow(rosterOf('s1', 's0'), -1);
  expect(hiddenOnes()).toEqual(['s0']);
  room.setVisible('s0', true);
  expect(hiddenOnes()).toEqual([]);
});
