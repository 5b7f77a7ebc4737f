// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { SampleClock } from './sample_clock';

test('blocks that arrive late have even times', () => {
  const clock = new SampleClock();
  const times = [0, 7, 3, 12, 0, 5].map((late_ms, i) => clock.timeOf(960 * i, 960, 1000 + 20 * (i + 1) + late_ms));
  times.forEach((time, i) => expect(time).toBeCloseTo(1000 + 20 * i, 6));
});

test('a clock that drifts is followed', () => {
  const clock = new SampleClock();
  let time = 0;
  for (let i = 0; i < 6000; i++) time = clock.timeOf(960 * i, 960, 20.002 * (i + 1));
  expect(Math.abs(time - 20.002 * 5999)).toBeLessThan(2.5);
});
