// SPDX-License-Identifier: Apache-2.0
// Every program of a room is killed, one after the other, and started again at once, as a supervisor does: how long until
// the room is back, for a viewer who comes again as soon as there is a hub. Speed is printed, not asserted.
// More: ROOMCAST_KILLS=200 node --test tests/network/back_after_kill.test.mjs
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { loadavg } from 'node:os';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, scratchFolder } from '../cli/program.mjs';
import { freePort } from './nginx.mjs';
import { RoomClient } from './room_client.mjs';
import { writeSmallRig } from './small_rig.mjs';

const kills = Number(process.env.ROOMCAST_KILLS ?? 8);
const sensorNames = ['s0', 's1', 's2'];
const fps = 20;
const longestLife_ms = 1_000;
const looksAgainAfter_ms = 10;
const backWithin_ms = 15_000; // of a machine that does much else
const timeout = { timeout: 60_000 + 10_000 * kills };

/** A program that is killed and started again at once. */
class Victim {
  constructor(t, name, args) {
    Object.assign(this, { name, args });
    this.start();
    t.after(() => this.program.stop('SIGKILL'));
  }

  start() {
    this.program = new Program(this.args(), { limitMs: timeout.timeout });
  }

  async killAndStart() {
    await this.program.stop('SIGKILL');
    this.start();
  }
}

/** A viewer who joins again as soon as it can, and knows when each sensor's last frame came, and who is there. */
class Watcher {
  #client;
  #over = false;

  constructor(url) {
    this.url = url;
    this.forget();
    this.done = this.#watch();
  }

  /** From now on it looks for frames that come after `name`, a sensor, a person, or the hub, was seen to be gone. */
  misses(name) {
    this.missed = { name, client: this.#client, rosters: this.#client?.rosters.length ?? 0 };
    this.forget();
  }

  forget() {
    this.seen = new Set();
    this.sawOf = this.#client?.sets.length ?? 0;
  }

  #sawItGone() {
    if (!this.missed) return true;
    const { name, client, rosters } = this.missed;
    const isGone = ({ sensors, people }) => !sensors.some((sensor) => sensor.name === name && sensor.online) && !people.some((person) => person.name === name);
    if (this.#client === client && !client.rosters.slice(rosters).some(isGone)) return false;
    this.missed = null;
    this.forget();
    return true;
  }

  async #watch() {
    while (!this.#over) {
      const cleanups = [];
      try {
        this.#client = await RoomClient.join({ after: (cleanup) => cleanups.push(cleanup) }, this.url, { name: 'watcher' });
        this.sawOf = 0;
        await this.#client.closed;
      } catch {
        // no hub just now
      }
      this.#client = undefined;
      cleanups.forEach((cleanup) => cleanup());
      await delay(looksAgainAfter_ms);
    }
  }

  /** Whether frames of all sensors have come since forget(), and these people are there. */
  sees(people) {
    const client = this.#client;
    const roster = client?.rosters.at(-1);
    if (!roster || !this.#sawItGone()) return false;
    for (const { frames } of client.sets.slice(this.sawOf)) frames.forEach(({ sensor }) => this.seen.add(sensor));
    const online = sensorNames.map((name) => client.sensor(name));
    const names = roster.people.map(({ name }) => name);
    return online.every((sensor) => sensor?.online && this.seen.has(sensor.id)) && people.every((name) => names.includes(name));
  }

  async end() {
    this.#over = true;
    this.#client?.socket.terminate();
    await this.done;
  }
}

async function back(watcher, people) {
  const begin = performance.now();
  while (!watcher.sees(people)) {
    assert.ok(performance.now() - begin < backWithin_ms, `the room is not back after ${backWithin_ms} ms`);
    await delay(looksAgainAfter_ms / 2);
  }
}

function percentile(times, share) {
  const sorted = [...times].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.ceil(share * sorted.length) - 1)];
}

function summary(name, times) {
  const [median, p95, max] = [0.5, 0.95, 1].map((share) => percentile(times, share).toFixed(0));
  return `${name} killed ${times.length} times: the room is back after p50 ${median}, p95 ${p95}, max ${max} ms`;
}

test('a_room_is_back_after_any_of_its_programs_was_killed', timeout, async (t) => {
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder, { fps });
  const url = `ws://127.0.0.1:${await freePort()}`;
  const hub = new Victim(t, 'hub', () => ['hub', '--listen', url.replace('ws://', ''), '--data', join(folder, 'data')]);
  await hub.program.port();
  let recording = 0;
  const victims = [
    hub,
    ...sensorNames.map((name) => new Victim(t, `sensor ${name}`, () => ['sensor', '--source', `rig:${rig}#${name}`, '--hub', url, '--wait'])),
    new Victim(t, 'recorder', () => ['record', join(folder, `${++recording}.mcap`), '--hub', `${url}`]),
  ];
  const watcher = new Watcher(url);
  await back(watcher, ['recorder']);
  const times = new Map(); // name -> milliseconds
  for (let n = 0; n < kills; ++n) {
    await delay(Math.random() * longestLife_ms);
    const victim = victims[n % victims.length];
    const [kind, sensor] = victim.name.split(' ');
    watcher.misses(sensor ?? kind);
    const killed = performance.now();
    await victim.killAndStart();
    await back(watcher, ['recorder']);
    times.set(kind, [...(times.get(kind) ?? []), performance.now() - killed]);
  }
  await watcher.end();
  for (const [name, ofName] of times) t.diagnostic(summary(name, ofName));
  t.diagnostic(`${summary('any', [...times.values()].flat())}; load ${loadavg()[0].toFixed(1)}`);
  assert.equal([...times.values()].flat().length, kills);
});
