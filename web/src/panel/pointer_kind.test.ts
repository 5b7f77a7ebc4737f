// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { kindOf } from './pointer_kind';

test('a pen is used like a finger, and an unknown pointer changes nothing', () => {
  expect(['mouse', 'touch', 'pen', ''].map(kindOf)).toEqual(['mouse', 'touch', 'touch', undefined]);
});
