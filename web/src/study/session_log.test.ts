// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { SessionLog, type LogRecord } from './session_log';
import { StudyProblem } from './study_api';

const record = (t: number, more = {}): LogRecord => ({ kind: 'speech', t, on: true, ...more });

/** A hub that takes each batch number once, fails when told to, and forgets nothing. */
function hub() {
  const taken: number[] = [];
  const calls: { number: number; isLast: boolean; bytes: number }[] = [];
  const state = { taken, calls, fails: undefined as StudyProblem | undefined, last: 0 };
  const send = (number: number, records: readonly LogRecord[], isLast: boolean) => {
    calls.push({ number, isLast, bytes: JSON.stringify(records).length });
    if (state.fails) return Promise.reject(state.fails);
    if (number > state.last) taken.push(...records.map(({ t }) => t));
    state.last = Math.max(state.last, number);
    return Promise.resolve();
  };
  return { state, send };
}

describe('the log of a session', () => {
  test('sends everything in order, in batches that count on', async () => {
    const { state, send } = hub();
    const log = new SessionLog(7, send);
    for (let t = 0; t < 700; t++) log.add(record(t));
    state.last = 7;
    await log.flush();
    expect(state.taken).toEqual(Array.from({ length: 700 }, (_, t) => t));
    expect(state.calls.map(({ number }) => number)).toEqual([8, 9, 10]);
    expect(log.isEmpty).toBe(true);
  });

  test('keeps batches small enough for a page that goes away', async () => {
    const { state, send } = hub();
    const log = new SessionLog(0, send);
    for (let t = 0; t < 40; t++) log.add(record(t, { words: 'ä'.repeat(4000) }));
    await log.flush();
    expect(state.taken.length).toBe(40);
    for (const { bytes } of state.calls) expect(bytes).toBeLessThan(60_000);
  });

  test('keeps records while the hub is away, and sends the same batch again', async () => {
    const { state, send } = hub();
    const log = new SessionLog(0, send);
    state.fails = new StudyProblem('away', false);
    log.add(record(1));
    await log.flush();
    expect(log.problem).toBe('away');
    log.add(record(2));
    state.fails = undefined;
    await log.flush();
    expect(state.calls.map(({ number }) => number)).toEqual([1, 1, 2]);
    expect(state.taken).toEqual([1, 2]);
    expect(log.problem).toBe('');
  });

  test('lets all who flush wait for the same sending', async () => {
    const { state, send } = hub();
    let answer = () => undefined as void;
    const log = new SessionLog(0, async (...batch) => {
      await new Promise<void>((resolve) => (answer = resolve));
      await send(...batch);
    });
    log.add(record(1));
    const first = log.flush();
    const second = log.flush();
    answer();
    await second;
    expect(log.isEmpty).toBe(true);
    await first;
    expect(state.calls.length).toBe(1);
  });

  test('ends when the hub refuses for good', async () => {
    const { state, send } = hub();
    const log = new SessionLog(0, send);
    state.fails = new StudyProblem('erased', true);
    log.add(record(1));
    await log.flush();
    expect(log.isLost).toBe(true);
    await log.flush();
    log.leave();
    expect(state.calls.length).toBe(1);
  });

  test('when the page goes away sends what has no answer, and the rest', async () => {
    const { state, send } = hub();
    const log = new SessionLog(0, send);
    state.fails = new StudyProblem('away', false);
    log.add(record(1));
    await log.flush();
    log.add(record(2));
    state.fails = undefined;
    log.leave();
    expect(state.taken).toEqual([1, 2]);
    expect(state.calls.slice(1)).toMatchObject([{ number: 1, isLast: true }, { number: 2, isLast: true }]);
  });
});
