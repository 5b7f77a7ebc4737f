// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { RoomState } from './room_state';
import { initialState, type ViewFrame } from './stream/protocol';

test('a paused sensor is known as such until its next frame, or a new connection', () => {
  const state = new RoomState();
  state.unseen.add(3).add(4).add(5);
  state.framesDecoded([{ sensor: 3 } as ViewFrame], 0);
  expect([...state.unseen]).toEqual([4, 5]);
  state.setConnection(initialState);
  expect(state.unseen.size).toBe(0);
});
