// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { PlaybackClock } from './playback_clock';

describe('the position in a recording', () => {
  let now_ms = 1000;
  const clock = () => {
    now_ms = 1000;
    return new PlaybackClock(() => now_ms);
  };

  test('advances with the time, at the wanted speed', () => {
    const position = clock();
    position.set(5);
    now_ms += 1500;
    expect(position.position_s).toBe(6.5);
    position.setSpeed(4);
    now_ms += 500;
    expect(position.position_s).toBe(8.5);
    expect(position.until_ms(10.5)).toBe(500);
    expect(position.until_ms(3)).toBe(0);
  });

  test('stands still while it is paused or held', () => {
    const position = clock();
    position.set(5);
    position.hold(true);
    position.pause(true);
    now_ms += 1000;
    expect(position.position_s).toBe(5);
    position.hold(false);
    now_ms += 1000;
    expect(position.position_s).toBe(5);
    expect(position.until_ms(6)).toBe(Infinity);
    position.pause(false);
    now_ms += 1000;
    expect(position.position_s).toBe(6);
  });
});
