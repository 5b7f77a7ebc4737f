// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { eventsCsv, eventText, EventLog, type HubEvent } from './events';

const event = (changes: Partial<HubEvent>): HubEvent => ({
  id: 1,
  number: changes.id ?? 1,
  at: 1_700_000_000.5,
  kind: 'joined',
  role: 'viewer',
  name: 'Ada',
  peer: '10.0.0.7:1',
  token_id: '',
  by: '',
  sentence: '',
  times: 1,
  ...changes,
});

describe('the log of events', () => {
  it('has the newest at the top, and an event that is counted again once', () => {
    const log = new EventLog();
    log.take([event({ id: 1, kind: 'refused' }), event({ id: 2 })], 2);
    log.take([event({ id: 1, number: 3, kind: 'refused', times: 2 })], 3);
    expect(log.list('all').map(({ id, times }) => [id, times])).toEqual([[1, 2], [2, 1]]);
    expect(log.newest).toBe(3);
  });

  it('begins again with a hub that was started anew, and has an end', () => {
    const log = new EventLog();
    log.take([event({ id: 7 })], 7);
    log.take([], 2);
    expect(log.newest).toBe(0);
    for (let id = 1; id <= 1200; id++) log.take([event({ id })], id);
    expect(log.list('all')).toHaveLength(1000);
    expect(log.list('all').at(-1)!.id).toBe(201);
  });

  it('shows what one asks for', () => {
    const log = new EventLog();
    const kinds = [
      event({ id: 1 }),
      event({ id: 2, role: 'sensor', name: 's0' }),
      event({ id: 3, kind: 'refused' }),
      event({ id: 4, kind: 'changed_sensor', role: '', name: 's0', by: 'Bo' }),
    ];
    log.take(kinds, 4);
    const ids = (filter: Parameters<EventLog['list']>[0]) => log.list(filter).map(({ id }) => id);
    expect(ids('people')).toEqual([3, 1]);
    expect(ids('sensors')).toEqual([4, 2]);
    expect(ids('refused')).toEqual([3]);
    expect(ids('admins')).toEqual([4]);
  });
});

describe('an event', () => {
  it('is said in words', () => {
    expect(eventText(event({}))).toBe('Ada joined');
    expect(eventText(event({ name: '' }))).toBe('a person joined');
    expect(eventText(event({ kind: 'refused', sentence: 'no token', times: 3 }))).toBe('Ada was refused: no token (3 times)');
    expect(eventText(event({ kind: 'muted', by: 'Bo' }))).toBe('Bo muted Ada');
    expect(eventText(event({ kind: 'of_a_later_version' }))).toBe('of_a_later_version Ada');
  });

  it('is a line of CSV that a spreadsheet cannot run', () => {
    const csv = eventsCsv([event({ name: '=cmd()', sentence: 'a "b", c' })]);
    expect(csv).toBe(
      'at,kind,role,name,by,sentence,times,peer,token_id\r\n' +
        `2023-11-14T22:13:20.500Z,joined,viewer,'=cmd(),,"a ""b"", c",1,10.0.0.7:1,\r\n`,
    );
  });
});
