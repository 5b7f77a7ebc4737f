// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { WantedMotion } from './wanted_motion';

const blended = { mode: 'blend', mixes: true, shown: 2, wanted: 2 } as const;

function told() {
  const messages: boolean[] = [];
  return { messages, motion: new WantedMotion((isWanted) => messages.push(isWanted)) };
}

test('motion is wanted some time after the first picture, and that is said once', () => {
  const { messages, motion } = told();
  for (const now_ms of [5000, 5100, 6400]) motion.drawn(blended, now_ms);
  expect(messages).toEqual([]);
  for (const now_ms of [6500, 6600, 9000]) motion.drawn(blended, now_ms);
  expect(messages).toEqual([true]);
});

test('of one sensor it is never wanted, of several only while they are blended', () => {
  const { messages, motion } = told();
  for (const now_ms of [0, 2000, 9000]) motion.drawn({ ...blended, shown: 1 }, now_ms);
  motion.drawn({ ...blended, mixes: false }, 9100);
  motion.drawn({ ...blended, mode: 'still' }, 9200);
  expect(messages).toEqual([]);
  motion.drawn(blended, 9300);
  motion.drawn({ ...blended, mode: 'mesh', mixes: false }, 9400);
  expect(messages).toEqual([true, false]);
});
