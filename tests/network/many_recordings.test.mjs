// SPDX-License-Identifier: Apache-2.0
// Recordings that are begun and ended at arbitrary moments while frames flow: each ends, and can be read. By the command
// line, the C API and the hub; roomcast_recorder_test does the same with the C++ library alone.
// Many: ROOMCAST_RECORDINGS=10000 node --test tests/network/many_recordings.test.mjs
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { existsSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { promisify } from 'node:util';

import { readFromStart } from '../cli/mcap.mjs';
import { Program, binary, scratchFolder } from '../cli/program.mjs';
import { ask, makeToken, recordingReaches } from './admin.mjs';
import { SendingSensor } from './room_client.mjs';

const recordings = Number(process.env.ROOMCAST_RECORDINGS ?? 10);
const atATime = 3; // recorders
const sensorCount = 6;
const fps = 30;
const longest_ms = 400;
const endsWithin_ms = 20_000;
const example = join(dirname(binary), 'roomcast_example_record');
const withoutExample = existsSync(example) ? false : `${example} is not built`;
const timeout = { timeout: 60_000 + 2_000 * recordings };

/** A hub with an admin, and sensors that keep it busy. */
async function startBusyHub(t) {
  const data = scratchFolder(t);
  const admin = (await makeToken(data, '--role', 'admin', '--ttl', '7d')).token;
  const program = new Program(['hub', '--listen', '127.0.0.1:0', '--no-align', '--data', data], { limitMs: timeout.timeout });
  t.after(() => program.stop('SIGKILL'));
  const port = await program.port();
  const url = `ws://127.0.0.1:${port}`;
  for (let n = 0; n < sensorCount; ++n) await SendingSensor.start(t, url, { name: `s${n}`, fps });
  return { program, port, url, admin };
}

async function assertWholeAndRemove(file) {
  const { whole } = await readFromStart(file);
  assert.ok(whole, `${file} has an end`);
  rmSync(file);
}

/** Runs `recordOnce(file)` so often, some at a time. */
async function recordOften(t, recordOnce) {
  const folder = scratchFolder(t);
  let begun = 0;
  const recordInTurn = async () => {
    while (begun < recordings) {
      const file = join(folder, `${begun++}.mcap`);
      await recordOnce(file);
      await assertWholeAndRemove(file);
    }
  };
  await Promise.all(Array.from({ length: atATime }, recordInTurn));
  t.diagnostic(`${begun} recordings`);
}

async function recordByCommand(url, file) {
  const recorder = new Program(['record', file, '--hub', url], { limitMs: endsWithin_ms });
  while (!existsSync(file) && recorder.child.exitCode === null) await delay(5);
  await delay(Math.random() * longest_ms);
  assert.equal(await recorder.stop('SIGINT'), 0, recorder.stderr);
}

test('recordings_by_the_command_line_end_whenever_they_are_asked_to', timeout, async (t) => {
  const { url } = await startBusyHub(t);
  await recordOften(t, (file) => recordByCommand(url, file));
});

test('recordings_by_the_c_api_end_whenever_they_are_asked_to', { ...timeout, skip: withoutExample }, async (t) => {
  const { url } = await startBusyHub(t);
  await recordOften(t, (file) => {
    const seconds = (Math.random() * longest_ms) / 1000;
    return promisify(execFile)(example, [url, file, String(seconds)], { timeout: endsWithin_ms, killSignal: 'SIGKILL' });
  });
});

test('recordings_by_the_hub_end_whenever_they_are_asked_to', timeout, async (t) => {
  const { program, port, admin } = await startBusyHub(t);
  const path = '/rooms/room/recording';
  const becomes = (wanted) => recordingReaches(port, admin, 'room', ({ state }) => state === wanted, endsWithin_ms);
  for (let n = 0; n < recordings; ++n) {
    assert.equal((await ask(port, admin, 'POST', path)).status, 201);
    await becomes('on');
    await delay(Math.random() * longest_ms * (n % 2));
    assert.equal((await ask(port, admin, 'DELETE', path)).status, 200);
    await assertWholeAndRemove((await becomes('off')).file);
  }
  await ask(port, admin, 'POST', path);
  assert.equal(await program.stop('SIGTERM'), 0, 'it ends while it records');
  t.diagnostic(`${recordings} recordings`);
});
