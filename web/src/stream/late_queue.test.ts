// SPDX-License-Identifier: Apache-2.0
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { LateQueue } from './late_queue';

describe('a late queue', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  function filled(delay_ms: number) {
    const done: string[] = [];
    const queue = new LateQueue(() => Date.now());
    queue.setDelay(delay_ms);
    const put = (what: string) => queue.put(() => done.push(what));
    return { done, queue, put };
  }

  test('without a delay does things at once', () => {
    const { done, put } = filled(0);
    put('a');
    expect(done).toEqual(['a']);
  });

  test('does each thing later by the delay, in order', () => {
    const { done, put } = filled(100);
    put('a');
    vi.advanceTimersByTime(60);
    put('b');
    vi.advanceTimersByTime(39);
    expect(done).toEqual([]);
    vi.advanceTimersByTime(1);
    expect(done).toEqual(['a']);
    vi.advanceTimersByTime(60);
    expect(done).toEqual(['a', 'b']);
  });

  test('does what waits before anything that comes after a change', () => {
    const { done, queue, put } = filled(100);
    put('a');
    put('b');
    queue.setDelay(0);
    put('c');
    expect(done).toEqual(['a', 'b', 'c']);
  });

  test('forgets what waits when it is cleared', () => {
    const { done, queue, put } = filled(100);
    put('a');
    queue.clear();
    put('b');
    vi.advanceTimersByTime(1000);
    expect(done).toEqual(['b']);
  });
});
