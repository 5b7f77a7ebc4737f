// SPDX-License-Identifier: Apache-2.0
// Clocks of the machines of a hub, a sensor and a recorder are set forwards and backwards by an hour while a room is
// shown and recorded. Views go on, recordings end where they ended, and tokens mean what they say.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { isFrame, readFromStart } from '../cli/mcap.mjs';
import { Program, run, scratchFolder } from '../cli/program.mjs';
import { ask, makeToken, recordingReaches } from './admin.mjs';
import { RoomClient } from './room_client.mjs';
import { assertMissedNothing, longestPause_ms, startSensor } from './rooms.mjs';
import { writeSmallRig } from './small_rig.mjs';
import { WallClock, noWallClocks } from './wall_clock.mjs';

const hour_s = 3_600;
const fps = 20;
const jumps_s = [hour_s, -hour_s, 0];
const between_ms = 2_000;
const longestStop_ms = 1_000;
const mostLoss_s = 1.1;
const sessionsAreLookedAtWithin_ms = 15_000;
const skip = noWallClocks;

/** A hub that asks for tokens, with a wall clock, and an admin. */
async function startHub(t) {
  const data = scratchFolder(t);
  const wall = new WallClock(data);
  const args = ['hub', '--listen', '127.0.0.1:0', '--data', data, '--access', 'token'];
  const program = new Program(args, { environment: wall.environment, limitMs: 120_000 });
  t.after(() => program.stop('SIGKILL'));
  const port = await program.port();
  const tokenFor = async (role, ttl) => (await makeToken(data, '--room', 'room', '--role', role, '--ttl', ttl)).token;
  const admin = (await makeToken(data, '--role', 'admin', '--ttl', '30d')).token;
  return { program, data, wall, port, url: `ws://127.0.0.1:${port}`, admin, tokenFor };
}

/** Frames of a recording, after checks that its times go on evenly. */
async function framesOf(file, { whole }) {
  const recording = await readFromStart(file);
  assert.equal(recording.whole, whole);
  const times_ms = recording.messages.filter(isFrame).map(({ logTime }) => Number(logTime / 1_000_000n));
  const steps_ms = times_ms.slice(1).map((time, i) => time - times_ms[i]);
  assert.ok(Math.min(...steps_ms) >= 0, `${file}: times go back by ${Math.min(...steps_ms)} ms`);
  assert.ok(Math.max(...steps_ms) < longestStop_ms, `${file}: ${Math.max(...steps_ms)} ms without a frame`);
  return times_ms;
}

function assertReachesEnd(times_ms, end_ms, what) {
  const loss_s = (end_ms - times_ms.at(-1)) / 1000;
  assert.ok(Math.abs(loss_s) < mostLoss_s, `${what}: ${loss_s} s are lost`);
}

test('clocks_that_are_set_stop_no_view_and_spoil_no_recording', { skip, timeout: 90_000 }, async (t) => {
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder, { fps });
  const { program, wall, port, url, admin, tokenFor } = await startHub(t);
  const clocks = { hub: wall, sensor: new WallClock(folder), recorder: new WallClock(folder) };
  const limitMs = 90_000;
  for (const n of [0, 1]) {
    const environment = { ROOMCAST_TOKEN: await tokenFor('sensor', '30d'), ...(n === 0 ? clocks.sensor.environment : {}) };
    await startSensor(t, url, rig, n, { environment, limitMs });
  }
  const viewer = await tokenFor('viewer', '30d');
  const witness = await RoomClient.join(t, url, { name: 'witness', token: viewer });
  await witness.until('both sensors', () => witness.seqsOf(0).length > 0 && witness.seqsOf(1).length > 0);

  const files = { ended: join(folder, 'ended.mcap'), killed: join(folder, 'killed.mcap') };
  const environment = { ROOMCAST_TOKEN: viewer, ...clocks.recorder.environment };
  const recorders = {};
  for (const [name, file] of Object.entries(files)) {
    recorders[name] = new Program(['record', file, '--hub', url], { environment, limitMs });
    t.after(() => recorders[name].stop('SIGKILL'));
  }
  await ask(port, admin, 'POST', '/rooms/room/recording');
  await recordingReaches(port, admin, 'room', ({ state }) => state === 'on');
  await witness.until('the recorders', () => witness.rosters.at(-1).viewers >= 3);
  witness.sets = [];

  for (const clock of Object.values(clocks)) {
    for (const jump_s of jumps_s) {
      clock.set(jump_s);
      await delay(between_ms);
    }
  }
  const killed_ms = Date.now();
  await recorders.killed.stop('SIGKILL');
  const ended_ms = Date.now();
  assert.equal(await recorders.ended.stop('SIGINT'), 0, recorders.ended.stderr);
  const hubEnded_ms = Date.now();
  await ask(port, admin, 'DELETE', '/rooms/room/recording');
  const { file } = await recordingReaches(port, admin, 'room', ({ state }) => state === 'off');

  assert.equal(witness.end, undefined, 'the witness saw it all in one session');
  assertMissedNothing(witness, [0, 1]);
  t.diagnostic(`longest pause ${longestPause_ms(witness).toFixed(0)} ms of ${witness.sets.length} sets`);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);
  assertReachesEnd(await framesOf(files.killed, { whole: false }), killed_ms, 'the killed recorder');
  assertReachesEnd(await framesOf(files.ended, { whole: true }), ended_ms, 'the recorder');
  assertReachesEnd(await framesOf(file, { whole: true }), hubEnded_ms, "the hub's recording");
  for (const recording of [...Object.values(files), file]) {
    const { code, stderr } = await run('info', recording);
    assert.equal(code, 0, stderr);
  }
  assert.equal(program.child.exitCode, null, 'the hub is well');
});

test('tokens_are_valid_by_the_clock_as_it_is_set', { skip, timeout: 60_000 }, async (t) => {
  const { wall, port, url, admin, tokenFor } = await startHub(t);
  const [brief, long] = [await tokenFor('viewer', '30m'), await tokenFor('viewer', '7d')];
  const ada = await RoomClient.join(t, url, { name: 'Ada', token: brief });
  const bob = await RoomClient.join(t, url, { name: 'Bob', token: long });

  wall.set(hour_s);
  const { reason } = await Promise.race([ada.closed, delay(sessionsAreLookedAtWithin_ms, { reason: 'nothing' })]);
  assert.match(reason, /expired/, "Ada's token is over by the hub's clock");
  const made = await ask(port, admin, 'POST', '/tokens', { room: 'room', role: 'viewer', ttl_s: 600 });
  assert.equal(made.status, 201);

  wall.set(0);
  await RoomClient.join(t, url, { name: 'Ada', token: brief });
  await RoomClient.join(t, url, { name: 'Cleo', token: made.body.token });
  wall.set(-hour_s);
  await RoomClient.join(t, url, { name: 'Dora', token: long });
  const listed = (await ask(port, admin, 'GET', '/tokens')).body.tokens.map(({ id }) => id);
  assert.ok(listed.includes(made.body.id), 'it is known still');
  await delay(between_ms);
  assert.equal(bob.end, undefined, 'Bob saw it all in one session');
});
