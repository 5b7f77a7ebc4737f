// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { factsOf } from './recording_row';

const one = { name: 'one', state: 'whole', bytes: 34_200_000, seconds: 151, began_at: 1_700_000_000, sensors: 3 } as const;

describe('a recording in the list', () => {
  test('says when it was made, how long and large it is, and by whom', () => {
    expect(factsOf({ ...one, by: 'Ada' })).toMatch(/^14 Nov 2023, .* · 2:31 min · 34\.20 MB · 3 sensors · by Ada$/);
    expect(factsOf({ ...one, voices: true })).toMatch(/ · 3 sensors · voices$/);
    expect(factsOf(one)).not.toMatch(/by/);
  });

  test('that cannot be read says when its file was changed', () => {
    expect(factsOf({ ...one, state: 'unreadable', seconds: 0, sensors: 0 })).toMatch(/^changed 14 Nov 2023, .* · 34\.20 MB$/);
  });
});
