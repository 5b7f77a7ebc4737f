// SPDX-License-Identifier: Apache-2.0
// A room over IPv6: page, sensor and viewers.
import assert from 'node:assert/strict';
import { request } from 'node:http';
import { networkInterfaces } from 'node:os';
import { test } from 'node:test';

import { Program, assertServes, scratchFolder } from '../cli/program.mjs';
import { RoomClient } from './room_client.mjs';
import { startSensor } from './rooms.mjs';
import { writeSmallRig } from './small_rig.mjs';

const hasIpv6 = Object.values(networkInterfaces()).flat().some(({ address }) => address === '::1');
const skip = hasIpv6 ? false : 'this machine has no IPv6';

async function startHubOnIpv6(t) {
  const program = new Program(['hub', '--listen', '[::1]:0']);
  t.after(() => program.stop('SIGKILL'));
  const [, port] = await program.prints(/open http:\/\/\[::1\]:(\d+)\//);
  return { program, port: Number(port), url: `ws://[::1]:${port}` };
}

test('room_works_over_ipv6', { skip }, async (t) => {
  const hub = await startHubOnIpv6(t);
  const sensor = await startSensor(t, hub.url, writeSmallRig(scratchFolder(t)), 0);
  const viewer = await RoomClient.join(t, hub.url);
  await viewer.moreSets(5);
  await assertServes(t, hub);
  const status = await new Promise((resolve, reject) => {
    request({ host: '::1', port: hub.port, path: '/healthz' }, (answer) => resolve(answer.resume().statusCode))
      .on('error', reject)
      .end();
  });
  assert.equal(status, 200);
  await hub.program.stop('SIGKILL');
  const [said] = await sensor.prints(/.*trying again/);
  assert.match(said, /the connection to the hub ended/);
});

test('hub_on_all_ipv6_addresses_is_there_for_ipv4_too', { skip }, async (t) => {
  const program = new Program(['hub', '--listen', '[::]:0', '--insecure', '--access', 'anyone']);
  t.after(() => program.stop('SIGKILL'));
  const [, port] = await program.prints(/\[::\]:(\d+)/);
  for (const host of ['[::1]', '127.0.0.1', 'localhost']) {
    await RoomClient.join(t, `ws://${host}:${port}`, { name: host });
  }
});

test('page_of_another_host_may_not_join_over_ipv6_either', { skip }, async (t) => {
  const hub = await startHubOnIpv6(t);
  const open = (origin) => RoomClient.open(t, hub.url, { origin });
  await open(`http://[::1]:${hub.port}`);
  await assert.rejects(open('http://[::2]'), /403/);
});
