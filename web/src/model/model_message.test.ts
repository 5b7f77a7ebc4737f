// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { readModelMessage } from './model_message';

// As in roomcast/recording/modeler/model_message_test.cpp.
const example = [
  ...[0x52, 0x43, 0x4d, 1, 1, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0],
  ...[0xff, 0xff, 0xff, 0xff, 0, 0, 0, 0, 7, 0, 0, 0, 3, 0, 0, 0, 1, 2, 3],
  ...[2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0],
];
const read = (bytes: number[]) => readModelMessage(new Uint8Array(bytes).buffer);

test('pieces are read with the places of their cubes', () => {
  const { isWhole, version, pieces } = read(example);
  expect(isWhole).toBe(true);
  expect(version).toBe(0x1_0000_0002n);
  expect(pieces.map(({ key }) => key)).toEqual(['-1,0,7', '2,2,2']);
  expect([...pieces[0]!.draco]).toEqual([1, 2, 3]);
  expect(pieces[1]!.draco.length).toBe(0);
});

test('what is cut off, or has more, is refused', () => {
  for (let length = 0; length < example.length; ++length) expect(() => read(example.slice(0, length))).toThrow();
  expect(() => read([...example, 0])).toThrow();
});

test('a later version is named so', () => {
  expect(() => read(example.map((byte, i) => (i === 3 ? 2 : byte)))).toThrow(/another version/);
});
