// SPDX-License-Identifier: Apache-2.0
// Sensors and viewers are killed at arbitrary moments, repeatedly, also while they are joining. The remaining clients
// miss nothing, and in the end all clients are back under the same id and pose.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, scratchFolder, startHub } from '../cli/program.mjs';
import { RoomClient } from './room_client.mjs';
import { assertMissedNothing, longestPause_ms, startSensor } from './rooms.mjs';
import { writeSmallRig } from './small_rig.mjs';

const kills = 40;
const longestLife_ms = 250;
const longestStop_ms = 2_000;

/** The same numbers in [0, 1) in every run, from a linear congruential generator (Park and Miller 1988). */
function randomNumbers(seed) {
  let state = seed;
  return () => (state = (state * 48_271) % 0x7fffffff) / 0x7fffffff;
}

/** A program that is killed and, if `startAgain` is called, started again at once. */
class Victim {
  constructor(t, args) {
    this.args = args;
    this.start();
    t.after(() => this.program.stop('SIGKILL'));
  }
  start() {
    this.program = new Program(this.args);
  }
  async startAgain() {
    await this.program.stop('SIGKILL');
    this.start();
  }
}

test('killing_sensors_and_viewers_at_random_costs_the_others_nothing', { timeout: 60_000 }, async (t) => {
  const random = randomNumbers(6);
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder, { fps: 20 });
  const hub = await startHub(t);
  await startSensor(t, hub.url, rig, 0);
  const witness = await RoomClient.join(t, hub.url, { name: 'witness' });
  const sensors = [1, 2, 3].map((n) => new Victim(t, ['sensor', '--source', `rig:${rig}#s${n}`, '--hub', hub.url]));
  const picture = ['--headless', '--png', join(folder, 'a.png')];
  const viewers = [1, 2].map(() => new Victim(t, ['view', '--hub', hub.url, ...picture, '--seconds', '60']));
  const names = ['s1', 's2', 's3'];
  await witness.until('all sensors', () => names.every((name) => witness.sensor(name)?.online));
  const before = names.map((name) => witness.sensor(name));

  const victims = [...sensors, ...viewers];
  for (let i = 0; i < kills; ++i) {
    await victims[Math.floor(random() * victims.length)].startAgain();
    await delay(random() * longestLife_ms);
  }
  await witness.until('everybody', () => {
    const allOnline = names.every((name) => witness.sensor(name).online);
    return allOnline && witness.rosters.at(-1).viewers === 1 + viewers.length;
  });
  assert.deepEqual(names.map((name) => witness.sensor(name)), before, 'same ids, same poses');
  const sets = witness.sets.length;
  await witness.until('all send', () => {
    const seen = new Set(witness.sets.slice(sets).flatMap(({ frames }) => frames.map(({ sensor }) => sensor)));
    return before.every(({ id }) => seen.has(id));
  });
  assertMissedNothing(witness, [witness.sensor('s0').id]);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);
  assert.equal(hub.program.child.exitCode, null, 'the hub is well');
});

test('hub_that_is_killed_again_and_again_finds_its_sensors_every_time', { timeout: 60_000 }, async (t) => {
  const random = randomNumbers(7);
  const rig = writeSmallRig(scratchFolder(t), { fps: 20 });
  const { program, port, url } = await startHub(t);
  for (const n of [0, 1]) await startSensor(t, url, rig, n);
  let hub = program;
  for (let i = 0; i < 6; ++i) {
    await delay(random() * longestLife_ms);
    await hub.stop('SIGKILL');
    hub = new Program(['hub', '--listen', `127.0.0.1:${port}`]);
    t.after(() => hub.stop('SIGKILL'));
    await hub.prints(/http/);
  }
  const witness = await RoomClient.join(t, url);
  await witness.until('both sensors send', () => {
    const ids = ['s0', 's1'].map((name) => witness.sensor(name)?.id);
    return ids.every((id) => witness.seqsOf(id).length > 5);
  });
});

test('all_clients_return_to_a_hub_that_was_frozen', { timeout: 60_000 }, async (t) => {
  const rig = writeSmallRig(scratchFolder(t), { fps: 20 });
  const hub = await startHub(t);
  const sensor = await startSensor(t, hub.url, rig, 0);
  const before = await RoomClient.join(t, hub.url);
  await before.moreSets(3);
  const entry = structuredClone(before.sensor('s0'));
  hub.program.child.kill('SIGSTOP');
  await sensor.prints(/trying again/);
  hub.program.child.kill('SIGCONT');
  const witness = await RoomClient.join(t, hub.url);
  await witness.until('it sends again', () => witness.seqsOf(0).length > 5);
  assert.deepEqual(witness.sensor('s0'), entry, 'same id, same pose');
  assert.equal(sensor.child.exitCode, null);
});
