// SPDX-License-Identifier: Apache-2.0
// A busy hub redirects new viewers to a less busy one, and no viewer is redirected back and forth.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, scratchFolder } from '../cli/program.mjs';
import { ask, makeToken } from './admin.mjs';
import { writeJoin } from './messages.mjs';
import { natsIsMissing, startNode } from './nats.mjs';
import { freePort } from './nginx.mjs';
import { RoomClient, SendingSensor } from './room_client.mjs';

const skip = natsIsMissing;
const busyError = 19;
const leastLoad = 0.013; // of a core: above the smallest load that busy_percent can express
const mostSensors = 30;

/** A hub in a cluster that counts as busy above this percentage of a core. */
async function startHub(t, node, busyPercent) {
  const folder = scratchFolder(t);
  const port = await freePort();
  const url = `ws://127.0.0.1:${port}`;
  const config = join(folder, 'roomcast.toml');
  writeFileSync(config, `listen = "127.0.0.1:${port}"\ndata = "${folder}"\nthreads = 1\nalign = false\npublic_url = "${url}"\n` +
    `[nats]\nservers = ["${node.url}"]\n[limits]\nbusy_percent = ${busyPercent}\n`);
  const admin = await makeToken(folder, '--role', 'admin');
  const program = new Program(['hub', '--config', config, '--verbose']);
  t.after(() => program.stop('SIGKILL'));
  await program.prints(/open http/);
  return { program, url, loads: async () => (await ask(port, admin.token, 'GET', '/hubs')).body.hubs.map(({ load }) => load) };
}

/** Two connected hubs. Sensors are added to the first one until its load is several times that of the other. */
async function startPair(t, firstBusyPercent) {
  const node = await startNode(t);
  const [first, second] = [await startHub(t, node, firstBusyPercent), await startHub(t, node, 75)];
  for (let sensors = 0; ; ++sensors) {
    const [own, other] = await first.loads();
    if (other !== undefined && own > leastLoad && own > 3 * other) break;
    assert.ok(sensors < mostSensors, `${own} and ${other} cores`);
    await SendingSensor.start(t, first.url, { name: `s${sensors}`, fps: 60, payloadBytes: 8000 });
    await delay(500); // until loads are reported again
  }
  return { first, second };
}

test('a_busy_hub_redirects_a_viewer_to_one_that_is_not', { skip }, async (t) => {
  const { first, second } = await startPair(t, 1);
  const guest = await RoomClient.open(t, first.url);
  guest.send(writeJoin({ name: 'guest' }));
  await guest.closed;
  assert.equal(guest.errors[0]?.code, busyError);
  assert.deepEqual(guest.otherHubs, [second.url]);

  const recorder = new Program(['record', `${scratchFolder(t)}/out.mcap`, '--hub', first.url, '--seconds', '20']);
  t.after(() => recorder.stop('SIGKILL'));
  const witness = await RoomClient.join(t, second.url);
  await witness.until('the recorder, who was told of the busy hub only', () => witness.rosters.at(-1)?.viewers === 2);
});

test('a_redirected_viewer_may_stay', { skip }, async (t) => {
  const { first } = await startPair(t, 1);
  const guest = await RoomClient.open(t, first.url);
  guest.send(writeJoin({ name: 'guest', redirected: true }));
  await guest.until('the welcome', () => guest.welcome);
});

test('a_hub_that_is_not_busy_redirects_no_viewer', { skip }, async (t) => {
  const { first } = await startPair(t, 0);
  await RoomClient.join(t, first.url);
});
