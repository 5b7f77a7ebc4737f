// SPDX-License-Identifier: Apache-2.0
// A hub behind an HTTPS reverse proxy, configured per docs/reverse-proxy.md: page, sensors and viewers can connect.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { request } from 'node:https';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, assertServes, scratchFolder, startHub } from '../cli/program.mjs';
import { makeCertificate } from './certificate.mjs';
import { nginxIsMissing, startNginx } from './nginx.mjs';
import { RoomClient } from './room_client.mjs';
import { startSensor } from './rooms.mjs';
import { writeSmallRig } from './small_rig.mjs';

const skip = nginxIsMissing;
const options = { rejectUnauthorized: false };

async function startBehindProxy(t) {
  const folder = scratchFolder(t);
  const web = join(folder, 'web');
  mkdirSync(web);
  writeFileSync(join(web, 'index.html'), 'the page');
  const certificate = await makeCertificate(t, folder);
  const hub = await startHub(t, '--web', web);
  const proxy = await startNginx(t, folder, hub.port, certificate.file);
  const host = `127.0.0.1:${proxy.port}`;
  return { folder, hub, proxy, host, plainUrl: `wss://${host}`, url: `wss://${host}#sha256=${certificate.fingerprint}` };
}

function get(host, path) {
  return new Promise((resolve, reject) => {
    request(`https://${host}${path}`, options, (answer) => {
      let body = '';
      answer.on('data', (text) => (body += text)).on('end', () => resolve({ status: answer.statusCode, body }));
    })
      .on('error', reject)
      .end();
  });
}

test('page_sensor_and_viewers_get_through_a_reverse_proxy', { skip }, async (t) => {
  const { folder, host, url, plainUrl } = await startBehindProxy(t);
  assert.deepEqual(await get(host, '/'), { status: 200, body: 'the page' });
  await startSensor(t, url, writeSmallRig(folder), 0);
  await assertServes(t, { url });

  const page = await RoomClient.join(t, plainUrl, { options: { ...options, origin: `https://${host}` } });
  await page.moreSets(10);
  await assert.rejects(RoomClient.open(t, plainUrl, { ...options, origin: 'https://elsewhere.example' }), /403/);
});

test('sensor_behind_a_proxy_comes_back_when_its_hub_does', { skip }, async (t) => {
  const { folder, hub, proxy, url, plainUrl } = await startBehindProxy(t);
  const sensor = await startSensor(t, url, writeSmallRig(folder), 0);
  await hub.program.stop('SIGKILL');
  await sensor.prints(/trying again/);
  while (!proxy.log().includes(' 502 ')) {
    assert.equal(sensor.child.exitCode, null, sensor.stderr);
    await delay(20);
  }
  const next = new Program(['hub', '--listen', `127.0.0.1:${hub.port}`]);
  t.after(() => next.stop('SIGKILL'));
  await next.prints(/http/);
  const viewer = await RoomClient.join(t, plainUrl, { options });
  await viewer.moreSets(5);
  assert.ok(viewer.sensor('s0').online);
});
