// SPDX-License-Identifier: Apache-2.0
// roomcast demo estimates the poses of its sensors itself; the simulator's true poses are used for comparison only.
import assert from 'node:assert/strict';
import { request } from 'node:http';
import { test } from 'node:test';

import { writeSmallRig } from './small_rig.mjs';
import { Program, run, scratchFolder, startHub } from '../cli/program.mjs';
import { RoomClient } from './room_client.mjs';

const [given, aligned] = [1, 2]; // PLACEMENT_...
const sensorCount = 2;
const limitMs = 200_000;
const exact_m = 0.03;

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
