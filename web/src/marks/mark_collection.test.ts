// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { expect, test } from 'vitest';
import { MarksSchema } from '../gen/control_pb';
import { MarkCollection } from './mark_collection';

const message = (init: object) => create(MarksSchema, init);

test('marks come and go as the hub says, and all of them are replaced on joining', () => {
  const marks = new MarkCollection();
  const ids = () => marks.list.map(({ id }) => id);
  marks.take(message({ all: true, marks: [{ id: 1 }, { id: 2 }] }));
  marks.take(message({ marks: [{ id: 3 }] }));
  expect(ids()).toEqual([1, 2, 3]);
  marks.take(message({ removed: [2, 99] }));
  expect(ids()).toEqual([1, 3]);
  marks.take(message({ all: true, marks: [{ id: 7 }] }));
  expect(ids()).toEqual([7]);
  marks.clear();
  expect(ids()).toEqual([]);
});
