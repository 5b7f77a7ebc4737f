// SPDX-License-Identifier: Apache-2.0
// roomcast demo estimates the poses of its sensors itself; the simulator's true poses are used for comparison only.
import assert from 'node:assert/strict';
import { existsSync, statSync } from 'node:fs';
import { request } from 'node:http';
import { join } from 'node:path';
import { test } from 'node:test';

import { writeSmallRig } from './small_rig.mjs';
import { Program, run, scratchFolder, startHub } from '../cli/program.mjs';
import { ask, recordingReaches } from './admin.mjs';
import { writeJoin } from './messages.mjs';
import { RoomClient } from './room_client.mjs';

const [given, aligned] = [1, 2]; // PLACEMENT_...
const sensorCount = 2;
const limitMs = 200_000;
const exact_m = 0.03;
const codeUsed = 14; // ERROR_CODE_USED
const ownerOnly = 0o700;

/** The roster of a demo once all its sensors have this placement. */
async function placedDemo(t, placement, ...options) {
  const args = ['demo', '--port', '0', '--sensors', String(sensorCount), '--fps', '5', ...options];
  const demo = new Program(args, { limitMs });
  t.after(() => demo.stop('SIGKILL'));
  const viewer = await RoomClient.join(t, `ws://127.0.0.1:${await demo.port()}`, { name: 'witness' });
  const sensors = () => viewer.rosters.at(-1)?.sensors ?? [];
  const areAll = () => sensors().length === sensorCount && sensors().every((entry) => entry.placement === placement);
  await viewer.until('all placed', areAll, limitMs);
  const placements = new Set(viewer.rosters.flatMap((roster) => roster.sensors.map((entry) => entry.placement)));
  await demo.stop('SIGKILL');
  return { sensors: sensors(), placements };
}

/** Position of the second sensor in the frame of the first. */
function secondFromFirst([first, second]) {
  const [a, b] = [first.worldFromDepth, second.worldFromDepth];
  const apart = [3, 7, 11].map((i) => b[i] - a[i]);
  return [0, 1, 2].map((column) => [0, 1, 2].reduce((sum, row) => sum + a[4 * row + column] * apart[row], 0));
}

test('a_demo_aligns_its_sensors', { timeout: 2 * limitMs }, async (t) => {
  const found = await placedDemo(t, aligned);
  assert.ok(!found.placements.has(given), 'nobody told them');
  const truth = await placedDemo(t, given, '--true-poses');
  const [is, should] = [found.sensors, truth.sensors].map(secondFromFirst);
  const off_m = Math.hypot(...is.map((metres, i) => metres - should[i]));
  t.diagnostic(`${(1000 * off_m).toFixed(1)} mm off`);
  assert.ok(off_m < exact_m, `${off_m} m`);
});

/** What a server answers to a page whose own name now resolves to this machine (DNS rebinding). */
function statusFor(host, port) {
  return new Promise((resolve, reject) => {
    const sent = request({ host: '127.0.0.1', port, path: '/api/v1/rooms', headers: { host } }, (answer) =>
      resolve(answer.resume().statusCode),
    );
    sent.on('error', reject).end();
  });
}

async function assertRefusesReboundNames(program) {
  const port = await program.port();
  assert.equal(await statusFor(`127.0.0.1:${port}`, port), 200);
  assert.equal(await statusFor(`evil.example:${port}`, port), 421);
}

test('a_demo_refuses_a_rebound_name', async (t) => {
  const demo = new Program(['demo', '--port', '0', '--sensors', '1', '--fps', '1'], { limitMs });
  t.after(() => demo.stop('SIGKILL'));
  await assertRefusesReboundNames(demo);
});

test('a_recording_that_is_played_refuses_a_rebound_name', async (t) => {
  const hub = await startHub(t);
  const sensor = new Program(['sensor', '--source', `rig:${writeSmallRig(scratchFolder(t))}#s0`, '--hub', hub.url, '--verbose']);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  const file = `${scratchFolder(t)}/room.mcap`;
  const recorded = await run('record', file, '--hub', hub.url, '--seconds', '1');
  assert.equal(recorded.code, 0, recorded.stderr);
  const player = new Program(['play', file, '--loop', '--port', '0']);
  t.after(() => player.stop('SIGKILL'));
  await assertRefusesReboundNames(player);
});

/** A demo with one slow sensor; its port, and the one-time code in the address that it prints. */
async function demoWithAdminLink(t, options = [], environment = {}) {
  const args = ['demo', '--port', '0', '--sensors', '1', '--fps', '2', '--true-poses', '--admin-link', ...options];
  const demo = new Program(args, { limitMs, environment });
  t.after(() => demo.stop('SIGKILL'));
  const [, port, code] = await demo.prints(/open http:\/\/127\.0\.0\.1:(\d+)\/#code=([0-9A-Z-]+)\n/);
  return { demo, port, code, url: `ws://127.0.0.1:${port}` };
}

test('an_admin_link_of_a_demo_works_once', async (t) => {
  const { port, code, url } = await demoWithAdminLink(t);
  const admin = await RoomClient.join(t, url, { code });
  assert.equal((await ask(port, admin.welcome.token, 'GET', '/tokens')).status, 200);
  const second = await RoomClient.open(t, url);
  second.send(writeJoin({ name: 'second', code }));
  await second.closed;
  assert.equal(second.errors[0]?.code, codeUsed);
});

/** Records the demo's room through its console's interface; returns the state of the finished recording. */
async function recordDemo(t, { port, code, url }) {
  const { welcome } = await RoomClient.join(t, url, { code });
  const reaches = (isReached) => recordingReaches(port, welcome.token, 'demo', isReached, limitMs);
  const begun = await ask(port, welcome.token, 'POST', '/rooms/demo/recording');
  assert.ok(begun.status < 300, JSON.stringify(begun.body));
  await reaches(({ state, frames }) => state === 'on' && frames > 1);
  assert.ok((await ask(port, welcome.token, 'DELETE', '/rooms/demo/recording')).status < 300);
  return reaches(({ state }) => state === 'off');
}

async function assertHasFrames(file) {
  const { code, stdout, stderr } = await run('info', file, '--json');
  assert.equal(code, 0, stderr);
  assert.ok(JSON.parse(stdout).sensors[0].frames > 0);
}

test('a_demo_records_into_a_private_folder_of_its_user', { timeout: limitMs }, async (t) => {
  const state = scratchFolder(t);
  const demo = await demoWithAdminLink(t, [], { XDG_STATE_HOME: state });
  const folder = join(state, 'roomcast', 'recordings');
  assert.ok(!existsSync(folder), 'a demo that is not recorded leaves no folder');
  const { file } = await recordDemo(t, demo);
  assert.ok(file.startsWith(folder), file);
  assert.equal(statSync(folder).mode & 0o777, ownerOnly);
  assert.equal(statSync(file).mode & 0o077, 0);
  await assertHasFrames(file);
});

test('a_demo_records_into_the_folder_that_is_named', { timeout: limitMs }, async (t) => {
  const folder = join(scratchFolder(t), 'of', 'mine');
  const { file } = await recordDemo(t, await demoWithAdminLink(t, ['--recordings', folder]));
  assert.ok(file.startsWith(folder), file);
  assert.equal(statSync(folder).mode & 0o777, ownerOnly);
  await assertHasFrames(file);
});
