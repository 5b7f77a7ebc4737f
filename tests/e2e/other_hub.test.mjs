// SPDX-License-Identifier: Apache-2.0
// The page moves to another hub by itself when its hub disappears, if the hubs share their rooms.
import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, rmSync } from 'node:fs';
import { get } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { natsIsMissing, startNode } from '../network/nats.mjs';
import { freePort } from '../network/nginx.mjs';
import { keepPicture, openPage, startBrowser } from './browser.mjs';
import { requireBuilt, run, startHub, startSensor } from './programs.mjs';
import { slow, stateOf, until, untilAllShown } from './waiting.mjs';

const slowWithNats = { ...slow, skip: natsIsMissing };

/** Two hubs with one secret over one NATS server, each with a public address. */
async function startTwins(t) {
  const node = await startNode(t);
  const folders = [0, 1].map(() => mkdtempSync(join(tmpdir(), 'roomcast-e2e-')));
  const token = async (role) => (await run('token', '--data', folders[0], '--room', 'room', '--role', role))[0];
  const tokens = { viewer: await token('viewer'), sensor: await token('sensor') };
  copyFileSync(join(folders[0], 'hub.secret'), join(folders[1], 'hub.secret'));
  const hubs = [];
  for (const data of folders) {
    const port = await freePort();
    const more = ['--access', 'token', '--no-align', '--nats', node.url, '--public-url', `ws://127.0.0.1:${port}`];
    const hub = await startHub(port, { data, more });
    t.after(() => hub.end('SIGKILL'));
    hubs.push(hub);
  }
  t.after(() => folders.forEach((folder) => rmSync(folder, { recursive: true, force: true })));
  return { hubs, tokens };
}

const policyOf = async (hub) => (await fetch(hub.page)).headers.get('content-security-policy');
const viewersAt = async (hub) => Number(/(\d+) viewers/.exec(await (await fetch(`${hub.page}healthz`)).text())[1]);

/** The HTTP status with which a hub answers a WebSocket request from a page of this site. */
function answerToPageOf(origin, hub) {
  const headers = {
    origin,
    connection: 'Upgrade',
    upgrade: 'websocket',
    'sec-websocket-version': '13',
    'sec-websocket-key': 'AAAAAAAAAAAAAAAAAAAAAA==',
    'sec-websocket-protocol': 'roomcast.v1',
  };
  return new Promise((done, failed) => {
    get(`${hub.page}ws`, { headers })
      .on('response', (response) => (response.resume(), done(response.statusCode)))
      .on('upgrade', (response, socket) => (socket.destroy(), done(response.statusCode)))
      .on('error', failed);
  });
}

describe('the page of a hub beside others', () => {
  for (const [isGone, signal] of [['is gone', 'SIGKILL'], ['hangs', 'SIGSTOP']]) {
    test(`continues at another hub when its own ${isGone}, with its token and its viewpoint`, slowWithNats, async (t) => {
      requireBuilt();
      const { hubs: [own, other], tokens } = await startTwins(t);
      const sensor = startSensor(other, 0, { fps: 4, token: tokens.sensor });
      t.after(() => sensor.end());
      await until('the page may go there', () => policyOf(own), (policy) => policy.includes(`connect-src 'self' ws://127.0.0.1:${other.port};`));
      const browser = await startBrowser({ width: 480, height: 320 });
      t.after(() => browser.end());
      const page = await openPage(browser.context, `${own.page}?panel=1#room=room&token=${tokens.viewer}`);
      await untilAllShown(page, 1);
      assert.equal(await viewersAt(other), 0);
      const address = page.url();

      own.child.kill(signal);
      const since_ms = performance.now();
      await until('it is at the other hub', () => viewersAt(other), (viewers) => viewers === 1);
      t.diagnostic(`there after ${Math.round(performance.now() - since_ms)} ms`);
      const { shownSets } = await stateOf(page);
      await until('new pictures', () => stateOf(page), (state) => state.phase === 'joined' && state.shownSets > shownSets + 4);
      await untilAllShown(page, 1);
      assert.equal(page.url(), address);
      assert.ok(!page.complaints.some((complaint) => /Security Policy/.test(complaint)), page.complaints.join('\n'));
      await keepPicture(page, 'other_hub');
    });
  }

  test('of a foreign site may not connect', slowWithNats, async (t) => {
    const { hubs: [own, other] } = await startTwins(t);
    await until('they know each other', () => policyOf(other), (policy) => policy.includes(`ws://127.0.0.1:${own.port};`));
    const from = (origin) => answerToPageOf(origin, other);
    assert.equal(await from(`http://127.0.0.1:${own.port}`), 101);
    assert.equal(await from('http://127.0.0.1:1'), 403);
    assert.equal(await from(`https://127.0.0.1:${own.port}`), 403);
  });
});
