// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import type { DrawMode } from '../view/draw_mode';
import { Conditions } from './conditions';
import type { Condition } from './study_plan';
import type { StudySeat } from './study_seat';

const plain: Condition = { name: 'c', seconds: 9, instruction: '', room: '', mode: '', latency_ms: 0, fps: 0, sensors_off: [], voice: true };

/** A page that remembers what is done to it. */
function page(canDraw: DrawMode[] = ['blend', 'mesh', 'points']) {
  const now = { mode: 'blend' as DrawMode, handicap: { latency_ms: 0, fps: 0 }, hears: true, isOn: true, hidden: new Set<string>() };
  const seat = {
    state: { roster: { sensors: [{ name: 's0' }, { name: 's1' }] } },
    stage: { setVisible: (name: string, isVisible: boolean) => (isVisible ? now.hidden.delete(name) : now.hidden.add(name)) },
    link: { handicap: (handicap: typeof now.handicap) => (now.handicap = handicap) },
    sound: {
      get isOn() {
        return now.isOn;
      },
      toggle: () => Promise.resolve((now.isOn = !now.isOn)),
      hearOthers: (wanted: boolean) => (now.hears = wanted),
    },
    mode: () => now.mode,
    setMode: (mode: DrawMode) => canDraw.includes(mode) && (now.mode = mode),
  };
  return { now, conditions: new Conditions(seat as unknown as StudySeat) };
}

describe('a condition', () => {
  test('is applied, and taken back', () => {
    const { now, conditions } = page();
    const troubles = conditions.apply({ ...plain, mode: 'points', latency_ms: 300, fps: 5, sensors_off: ['s1'], voice: false });
    expect(troubles).toEqual([]);
    expect(now).toEqual({ mode: 'points', handicap: { latency_ms: 300, fps: 5 }, hears: false, isOn: false, hidden: new Set(['s1']) });
    conditions.end();
    expect(now).toMatchObject({ mode: 'blend', handicap: { latency_ms: 0, fps: 0 }, hears: true, hidden: new Set() });
  });

  test('takes back the one before it', () => {
    const { now, conditions } = page();
    conditions.apply({ ...plain, mode: 'points', sensors_off: ['s0'] });
    conditions.apply({ ...plain, sensors_off: ['s1'] });
    expect(now).toMatchObject({ mode: 'blend', hidden: new Set(['s1']) });
  });

  test('that cannot be applied says what is missing', () => {
    const { conditions } = page(['blend']);
    expect(conditions.apply({ ...plain, mode: 'mesh', sensors_off: ['s7'] })).toEqual([
      'it draws as blend, not as mesh',
      'the room has no sensor "s7"',
    ]);
  });
});
