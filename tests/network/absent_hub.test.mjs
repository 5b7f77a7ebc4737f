// SPDX-License-Identifier: Apache-2.0
// A sensor that waits for its hub: it neither gives up nor grows, and joins as soon as the hub is up. While waiting it
// repeats the same steps, so that a few seconds are representative of hours.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { once } from 'node:events';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, scratchFolder } from '../cli/program.mjs';
import { writeSmallRig } from './small_rig.mjs';

const watched_ms = 6_000;
const mayGrow_kB = 4_000;

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  await once(server, 'close');
  return port;
}

const residentKb = (pid) => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1]);
const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

test('a_sensor_outlives_the_absence_of_its_hub_and_does_not_grow', { timeout: 60_000 }, async (t) => {
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder, { fps: 30 });
  const port = await freePort();
  const listen = ['hub', '--listen', `127.0.0.1:${port}`, '--data', join(folder, 'data')];
  const sensor = new Program(
    ['sensor', '--source', `rig:${rig}#s0`, '--hub', `ws://127.0.0.1:${port}`, '--verbose', '--wait'],
    { limitMs: 60_000 },
  );
  t.after(() => sensor.stop('SIGKILL'));
  const first = new Program(listen);
  t.after(() => first.stop('SIGKILL'));
  await sensor.prints(/joined/);
  await first.stop('SIGKILL');
  await pause(1_000);
  const before = residentKb(sensor.child.pid);
  await pause(watched_ms);
  const grown = residentKb(sensor.child.pid) - before;
  t.diagnostic(`grew by ${grown} kB in ${watched_ms} ms without a hub, from ${before}`);
  assert.ok(grown < mayGrow_kB);

  sensor.stderr = '';
  const second = new Program(listen);
  t.after(() => second.stop('SIGKILL'));
  await sensor.prints(/joined/);
});
