// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { describe, expect, test } from 'vitest';
import { Placement, RosterSchema } from '../gen/control_pb';
import { roomRoster } from '../room_roster';
import { initialState, type SensorTraffic } from '../stream/protocol';
import { problems, type Known } from './problems';

const joined = { ...initialState, phase: 'joined' } as const;
const s0 = { id: 0, name: 's0', online: true, fps: 5, placement: Placement.GIVEN };
const traffic: SensorTraffic = {
  sensor: 0,
  frames: 9,
  bytes: 9,
  skipped: 0,
  missed: 0,
  lastSeq: 8,
  lastSetId: 8n,
  lastCapture_ms: 10_000,
  isHeldBack: false,
  isSmall: false,
  problem: '',
};

function known(change: Partial<Known>, sensors: object[] = [s0], counts: SensorTraffic[] = [traffic]): Known {
  return {
    broken: '',
    connection: joined,
    roster: roomRoster(create(RosterSchema, { sensors })),
    status: { clock: undefined, received_bytes: 0, sensors: counts, decoded: [], colorProblem: '' },
    hubAddress: 'ws://lab:7600',
    ...change,
  };
}

const sentences = (facts: Known, room_ms = 10_100) => problems(facts, room_ms, 0).map((problem) => problem.sentence);

describe('the list of problems', () => {
  test('is empty when all is well', () => expect(sentences(known({}))).toEqual([]));

  test('begins with failures', () => {
    expect(
      sentences(known({ broken: 'No WebGL.', connection: { ...joined, phase: 'waiting', sentence: 'x' } })),
    ).toEqual(['No WebGL.']);
  });

  test('says that a slow connection makes pictures coarser, once for all sensors', () => {
    const small = [0, 1].map((sensor) => ({ ...traffic, sensor, isSmall: true }));
    const both = [s0, { ...s0, id: 1, name: 's1' }];
    expect(sentences(known({}, both, small))).toEqual([expect.stringMatching(/connection is slow/)]);
    expect(sentences(known({}, both, small), 15_000)).toHaveLength(1); // late, but that is no fault of the sensors
    expect(sentences(known({}, both, small), 21_000)).toHaveLength(3);
  });

  test('names the sensors that a slow connection holds back, and does not call them silent', () => {
    const counts = [{ ...traffic, isSmall: true, lastCapture_ms: 70_000 }, { ...traffic, sensor: 1, isHeldBack: true }];
    const both = [s0, { ...s0, id: 1, name: 's1' }];
    expect(sentences(known({}, both, counts), 70_000)).toEqual([expect.stringMatching(/too slow for all.* of s1\.$/)]);
  });

  test('does not take the last small picture of a sensor that is gone for a slow connection', () => {
    const gone = { ...s0, id: 1, name: 's1', online: false };
    const counts = [traffic, { ...traffic, sensor: 1, isSmall: true }];
    expect(sentences(known({}, [s0, gone], counts))).toEqual([expect.stringMatching(/s1 is gone/)]);
  });

  test('has a hub that is gone, with the time to the next try', () => {
    const connection = { ...joined, phase: 'waiting' as const, sentence: 'The hub has stopped.', retryAt_ms: 2900 };
    expect(problems(known({ connection }), 0, 0)).toEqual([
      { severity: 'error', sentence: 'The hub has stopped.', count: 'Trying again in 3 s.' },
    ]);
    expect(problems(known({ connection: { ...connection, phase: 'connecting' } }), 0, 0)).toEqual([
      { severity: 'error', sentence: 'The hub has stopped.', count: 'Trying again.' },
    ]);
    expect(problems(known({ connection: { ...connection, retryAt_ms: undefined, ended: true } }), 0, 0)).toEqual([
      { severity: 'error', sentence: 'The hub has stopped.' },
    ]);
    expect(sentences(known({ connection: { ...connection, reload: true } }))).toEqual(['The hub has stopped.']);
  });

  test('has a room without sensors, with the command that adds one', () => {
    expect(sentences(known({}, []))[0]).toMatch(/roomcast sensor --source sim --hub ws:\/\/lab:7600/);
  });

  test('has a sensor that is gone, or all of them', () => {
    const gone = { ...s0, id: 1, name: 's1', online: false };
    expect(sentences(known({}, [s0, gone]))).toEqual(['Sensor s1 is gone; its last picture is shown in grey.']);
    expect(sentences(known({}, [gone]))[0]).toMatch(/All sensors are gone/);
  });

  test('has a sensor that has been silent for more than three seconds', () => {
    expect(sentences(known({}), 12_900)).toEqual([]);
    expect(problems(known({}), 15_000, 0)).toEqual([
      { severity: 'error', sentence: 'Sensor s0 is silent.', count: 'Its last picture is 5 s old.' },
    ]);
    const opened = { ...joined, openedAt_ms: 50_000 };
    expect(problems(known({ connection: opened }), 15_000, 55_000)).toEqual([]);
    expect(problems(known({ connection: opened }), 15_000, 65_000)).toHaveLength(1);
    expect(sentences(known({}, [{ ...s0, fps: 0.5 }]), 15_000)).toEqual([]);
  });

  test('has no sensor that is silent because nobody sees what it shows', () => {
    expect(sentences(known({ unseen: new Set([0]) }), 15_000)).toEqual([]);
    expect(sentences(known({ unseen: new Set([1]) }), 15_000)).toHaveLength(1);
  });

  test('has an unplaced sensor', () => {
    const lost = { ...s0, placement: Placement.UNPLACED };
    expect(sentences(known({}, [lost]))[0]).toMatch(/Sensor s0 is not placed yet: it is shown/);
    const told = { ...lost, placementNote: 'turn it towards s1' };
    expect(sentences(known({}, [told]))[0]).toMatch(/placed yet: turn it towards s1\. It is shown/);
  });

  test('has several unplaced sensors without a reason in one sentence', () => {
    const lost = { ...s0, placement: Placement.UNPLACED };
    const others = ['s1', 's2'].map((name, n) => ({ ...lost, id: n + 1, name }));
    expect(sentences(known({}, [lost, ...others]))).toEqual([
      'Sensors s0, s1, and s2 are not placed yet: they are shown at provisional places.',
    ]);
    const refused = { ...lost, id: 3, name: 's3', placementNote: 'turn it towards s1' };
    expect(sentences(known({}, [lost, ...others, refused]))).toHaveLength(2);
  });

  test('has a moved sensor, with the reason why it is not aligned again', () => {
    const moved = { ...s0, placement: Placement.ALIGNED, moved: true };
    expect(sentences(known({}, [moved]))).toEqual([
      'Sensor s0 was moved: it is shown where it was until it is aligned again.',
    ]);
    const told = { ...moved, placementNote: 'Turn it towards s1' };
    expect(sentences(known({}, [told]))[0]).toMatch(/again\. Turn it towards s1\.$/);
  });

  test('has a sensor with an unconfirmed pose', () => {
    const remembered = { ...s0, placement: Placement.ALIGNED, unverified: true, placementNote: 'nothing is shared' };
    expect(sentences(known({}, [remembered]))[0]).toMatch(/^Sensor s0 is shown at its stored pose, .*confirmed yet\. Nothing is shared\.$/);
  });

  test('has a failed decoder, or colour that cannot be decoded', () => {
    expect(sentences(known({}, [s0], [{ ...traffic, problem: 'it gave up.' }]))).toEqual(['Sensor s0: it gave up.']);
    const facts = known({});
    facts.status!.colorProblem = 'No VP9.';
    expect(sentences(facts)).toEqual(['No VP9.']);
  });
});
