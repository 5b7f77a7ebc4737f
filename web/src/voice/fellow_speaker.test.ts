// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { fellowOf, isFellow, silentFellowOf } from './fellow_speaker';
import { speakerOf } from './sensor_speaker';

test('those who play a recording are nobody who is in it', () => {
  expect(isFellow(fellowOf(1))).toBe(true);
  expect(isFellow(silentFellowOf(1))).toBe(true);
  expect(fellowOf(1)).not.toBe(silentFellowOf(1));
  for (const recorded of [1, 2048, speakerOf(0), speakerOf(65_535)]) expect(isFellow(recorded)).toBe(false);
});
