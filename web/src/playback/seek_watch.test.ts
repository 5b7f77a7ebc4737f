// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { SeekWatch } from './seek_watch';

describe('the time that a seek takes', () => {
  test('ends with a picture of every sensor, and with the moment itself', () => {
    const watch = new SeekWatch();
    watch.asked(100);
    watch.show([{ sensor: 0, seq: 99 }, { sensor: 1, seq: 99 }], 110); // of the moment before
    expect(watch.first_ms).toBeUndefined();
    watch.take({ seeks: 1, moment: [] });
    watch.take({ seeks: 1, moment: [{ sensor: 0, seq: 7 }, { sensor: 1, seq: 3 }] });
    watch.show([{ sensor: 0, seq: 4 }], 150);
    expect(watch.first_ms).toBeUndefined();
    watch.show([{ sensor: 1, seq: 3 }], 180);
    expect([watch.first_ms, watch.exact_ms]).toEqual([80, undefined]);
    watch.show([{ sensor: 0, seq: 7 }], 220);
    expect([watch.first_ms, watch.exact_ms]).toEqual([80, 120]);
    watch.show([{ sensor: 0, seq: 8 }], 300);
    expect(watch.exact_ms).toBe(120);
  });
});
