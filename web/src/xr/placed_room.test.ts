// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { keptIn } from '../storage';
import { keepPlaced, keptPlaced } from './placed_room';

const memory = () => keptIn(() => { throw new Error('blocked'); }).store;

test('the place of each room is kept', () => {
  const store = memory();
  const placed = { handle: 'a', x: 1, z: -2, heading: 0.5 };
  keepPlaced(store, 'lab', placed);
  expect(keptPlaced(store, 'lab')).toEqual(placed);
  expect(keptPlaced(store, 'other')).toBeUndefined();
});

test('what others have kept there is no place', () => {
  const store = memory();
  for (const text of ['', 'x', 'null', '{"handle":1,"x":0,"z":0,"heading":0}', '{"handle":"a","x":null,"z":0,"heading":0}']) {
    store.setItem('roomcast.placed.lab', text);
    expect(keptPlaced(store, 'lab')).toBeUndefined();
  }
});
