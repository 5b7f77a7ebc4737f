// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { authorKey } from './author_key';
import { keptIn } from './storage';

const emptyStore = () => keptIn(() => { throw new Error('blocked'); }).store;

test('a key is random, and the same again in the same browser', () => {
  const store = emptyStore();
  const key = authorKey(store);
  expect(key).toHaveLength(16);
  expect(authorKey(store)).toEqual(key);
  expect(authorKey(emptyStore())).not.toEqual(key);
});

test('a key that somebody has damaged is replaced', () => {
  const store = emptyStore();
  store.setItem('roomcast.author', 'nonsense');
  const key = authorKey(store);
  expect(key).toHaveLength(16);
  expect(authorKey(store)).toEqual(key);
});
