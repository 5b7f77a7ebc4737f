// SPDX-License-Identifier: Apache-2.0
// A stranger's walk: a hub for others with encryption and tokens, two sensors and a colleague in another network (a network
// namespace), a token that is revoked, a restart, and all is still there. Needs root, for the namespace.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, run, scratchFolder } from '../cli/program.mjs';
import { makeToken } from './admin.mjs';
import { writeSmallRig } from './small_rig.mjs';

const hubAddress = '10.77.3.1';
const colleagueAddress = '10.77.3.2';
const suffix = String(process.pid % 10_000);
const names = { namespace: `rc${suffix}`, here: `rch${suffix}`, there: `rct${suffix}` };

function ip(...args) {
  const { status, stderr, error } = spawnSync('ip', args, { encoding: 'utf8' });
  if (error || status !== 0) throw new Error(error?.message ?? stderr);
}

function whyNot() {
  if (process.getuid?.() !== 0) return 'making a network namespace takes root';
  try {
    ip('netns', 'add', names.namespace);
    ip('netns', 'del', names.namespace);
    return false;
  } catch (error) {
    return `no network namespace can be made here: ${error.message}`;
  }
}

/** Another network, joined to this machine by one cable; what runs `through` it has its address there. */
function otherNetwork(t) {
  ip('netns', 'add', names.namespace);
  t.after(() => ip('netns', 'del', names.namespace));
  ip('link', 'add', names.here, 'type', 'veth', 'peer', 'name', names.there, 'netns', names.namespace);
  ip('addr', 'add', `${hubAddress}/30`, 'dev', names.here);
  ip('link', 'set', names.here, 'up');
  ip('-n', names.namespace, 'addr', 'add', `${colleagueAddress}/30`, 'dev', names.there);
  ip('-n', names.namespace, 'link', 'set', names.there, 'up');
  return ['ip', 'netns', 'exec', names.namespace];
}

async function startHub(t, data, port = 0) {
  const hub = new Program(['hub', '--listen', `${hubAddress}:${port}`, '--data', data, '--verbose'], { limitMs: 120_000 });
  t.after(() => hub.stop('SIGKILL'));
  const [, url, taken] = await hub.prints(/--hub (wss:\/\/[0-9.]+:(\d+)#sha256=[0-9a-f]{64})/);
  return { hub, url, port: Number(taken) };
}

async function startSensor(t, through, url, token, rig, name) {
  const args = ['sensor', '--source', `rig:${rig}#${name}`, '--hub', url, '--token', token, '--verbose'];
  const sensor = new Program(args, { through, limitMs: 120_000 });
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  return sensor;
}

async function look(through, folder, url, token) {
  const png = join(folder, `${Math.random()}.png`);
  const credential = token ? ['--token', token] : [];
  const args = ['view', '--hub', url, '--headless', '--size', '64,48', '--png', png, ...credential];
  const viewer = new Program(args, { through });
  const code = await viewer.ended;
  return { code, stderr: viewer.stderr, drew: existsSync(png) };
}

test('stranger_walks_from_nothing_to_a_shared_room', { skip: whyNot(), timeout: 120_000 }, async (t) => {
  const folder = scratchFolder(t);
  const data = join(folder, 'data');
  const rig = writeSmallRig(folder);
  const through = otherNetwork(t);
  const first = await startHub(t, data);

  const tokens = {};
  for (const name of ['s0', 's1']) tokens[name] = await makeToken(data, '--room', 'room', '--role', 'sensor', '--name', name);
  tokens.colleague = await makeToken(data, '--room', 'room', '--role', 'viewer', '--name', 'Ada');
  await startSensor(t, through, first.url, tokens.s0.token, rig, 's0');
  const second = await startSensor(t, through, first.url, tokens.s1.token, rig, 's1');

  assert.deepEqual(await look(through, folder, first.url, tokens.colleague.token), { code: 0, stderr: '', drew: true });
  const stranger = await look(through, folder, first.url);
  assert.equal(stranger.code, 1);
  assert.match(stranger.stderr, /takes a token for role viewer/);
  assert.equal(stranger.drew, false);

  assert.equal((await run('token', '--data', data, '--revoke', tokens.s1.id)).code, 0);
  assert.equal(await second.ended, 1);
  assert.match(second.stderr, /revoked/);

  assert.equal(await first.hub.stop('SIGTERM'), 0);
  const again = await startHub(t, data, first.port);
  assert.equal(again.url, first.url, 'the same certificate');
  assert.equal((await look(through, folder, again.url, tokens.colleague.token)).code, 0, 'sensor and token still hold');
  const refused = new Program(
    ['sensor', '--source', `rig:${rig}#s1`, '--hub', again.url, '--token', tokens.s1.token], { through });
  assert.equal(await refused.ended, 1);
  assert.match(refused.stderr, /revoked/);
});
