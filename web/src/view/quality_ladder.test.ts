// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { headsetPace, qualities, QualityLadder } from './quality_ladder';

/** Draws for `seconds` on a machine with `cost` ms per picture; returns the quality after each draw. */
function draw(ladder: QualityLadder, seconds: number, cost: (step: number, ratio: number) => number, from = 0) {
  const history = [];
  for (let now = from; now < from + 1000 * seconds;) {
    const { step, pixelRatio } = ladder.quality;
    const took = cost(step, pixelRatio);
    now += took;
    ladder.judge(took, now);
    history.push(ladder.quality);
  }
  return history;
}

/** Like a software renderer on two cores: 360 ms for the whole grid. */
const software = (step: number, ratio: number) => 330 / step ** 1.6 + 25 * ratio ** 2;

describe('the quality ladder', () => {
  test('goes to the finest grid on a quick machine', () => {
    const ladder = new QualityLadder();
    draw(ladder, 1, () => 3);
    expect(ladder.quality).toEqual(qualities[0]);
  });

  test('coarsens the grid on a slow machine', () => {
    const ladder = new QualityLadder();
    draw(ladder, 10, software);
    const { step, pixelRatio } = ladder.quality;
    expect(software(step, pixelRatio)).toBeLessThan(60);
  });

  test('stays at the finest grid on request, however slow', () => {
    const ladder = new QualityLadder();
    ladder.choose('best');
    draw(ladder, 10, () => 500);
    expect(ladder.quality).toEqual(qualities[0]);
  });

  test('stays where one wants it, also on a quick machine, and goes on by itself afterwards', () => {
    const ladder = new QualityLadder();
    ladder.choose('coarse');
    draw(ladder, 10, () => 3);
    expect(ladder.quality).toEqual(qualities.at(-1));
    ladder.choose('auto');
    draw(ladder, 10, () => 3);
    expect(ladder.quality).toEqual(qualities[0]);
  });

  test('a headset is given less time for a picture than a screen', () => {
    const ladder = new QualityLadder();
    draw(ladder, 10, () => 30);
    expect(ladder.quality).toEqual(qualities[0]);
    ladder.setPace(headsetPace);
    draw(ladder, 1, () => 30, 10_000);
    expect(ladder.quality).not.toEqual(qualities[0]);
  });

  test('does not go below the last rung', () => {
    const ladder = new QualityLadder();
    draw(ladder, 30, () => 500);
    expect(ladder.quality).toEqual(qualities.at(-1));
  });

  test('tries finer grids less and less often after failures', () => {
    const ladder = new QualityLadder();
    const history = draw(ladder, 120, (step) => (step >= 4 ? 10 : 100));
    const mistakes = history.filter((quality, i) => quality.step < 4 && history[i - 1]?.step === 4).length;
    expect(mistakes).toBeGreaterThan(0);
    expect(mistakes).toBeLessThanOrEqual(8);
  });
});
