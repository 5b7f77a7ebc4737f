// SPDX-License-Identifier: Apache-2.0
// Poses found by the owner of a shared room outlive the owner: the hub that takes over keeps them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, scratchFolder } from '../cli/program.mjs';
import { makeToken } from './admin.mjs';
import { writePlacement } from './messages.mjs';
import { natsIsMissing, startNode } from './nats.mjs';
import { RoomClient, SendingSensor } from './room_client.mjs';

const aligned = 2;
const poseAt = (x_m) => [1, 0, 0, x_m, 0, 1, 0, 1.5, 0, 0, 1, 0, 0, 0, 0, 1];

async function startSharing(t, node) {
  const folder = scratchFolder(t);
  const admin = await makeToken(folder, '--role', 'admin');
  const program = new Program(['hub', '--listen', '127.0.0.1:0', '--nats', node.url, '--verbose', '--data', folder], { limitMs: 90_000 });
  t.after(() => program.stop('SIGKILL'));
  return { program, url: `ws://127.0.0.1:${await program.port()}`, admin: admin.token };
}

const startSensor = (t, hub, name) => SendingSensor.start(t, hub.url, { name, fps: 10, worldFromDepth: [] });

/** True if this hub estimates the sensors' poses. */
function owns({ program }) {
  const begun = program.stderr.match(/: estimates the poses of the sensors of "room"/g) ?? [];
  return begun.length > (program.stderr.match(/no longer estimates/g) ?? []).length;
}

async function untilOneOwns(hubs) {
  for (let tries = 0; ; ++tries) {
    const owners = hubs.filter(owns);
    if (owners.length === 1) return owners[0];
    assert.ok(tries < 200, `${owners.length} hubs own the room`);
    await delay(50);
  }
}

const isAt = (client, name, x_m) => {
  const sensor = client.sensor(name);
  return sensor?.placement === aligned && sensor.worldFromDepth.join() === poseAt(x_m).join();
};

test('a_hub_that_takes_over_a_room_keeps_its_poses', { skip: natsIsMissing, timeout: 90_000 }, async (t) => {
  const node = await startNode(t);
  const hubs = await Promise.all([0, 1, 2].map(() => startSharing(t, node)));
  await Promise.all(hubs.map((hub, i) => startSensor(t, hub, `s${i}`)));
  const viewers = await Promise.all(hubs.map((hub) => RoomClient.join(t, hub.url)));
  await Promise.all(viewers.map((viewer) => viewer.until('all sensors', () => [0, 1, 2].every((n) => viewer.sensor(`s${n}`)?.online))));
  const owner = await untilOneOwns(hubs);

  const aligner = await RoomClient.join(t, owner.url, { name: 'aligner', aligner: true, token: owner.admin });
  await aligner.until('all sensors', () => [0, 1, 2].every((n) => aligner.sensor(`s${n}`)));
  for (const n of [0, 1, 2]) aligner.send(writePlacement({ sensor: aligner.sensor(`s${n}`).id, worldFromDepth: poseAt(n) }));
  await Promise.all(viewers.map((viewer) => viewer.until('their poses', () => [0, 1, 2].every((n) => isAt(viewer, `s${n}`, n)))));

  const lost = hubs.indexOf(owner);
  owner.program.child.kill('SIGKILL');
  const others = hubs.filter((hub) => hub !== owner);
  const heir = await untilOneOwns(others);
  const watching = viewers.filter((_, i) => i !== lost);
  await Promise.all(watching.map((viewer) => viewer.until('its sensor is gone', () => viewer.sensor(`s${lost}`).online === false)));
  await startSensor(t, others.find((hub) => hub !== heir), `s${lost}`); // the sensor comes back at another hub
  await Promise.all(watching.map((viewer) => viewer.until('it is back', () => viewer.sensor(`s${lost}`).online)));
  await delay(1000); // several heartbeats of the new owner
  const late = await RoomClient.join(t, heir.url);
  await late.until('the roster', () => late.rosters.length > 0);
  for (const viewer of [...watching, late]) {
    for (const n of [0, 1, 2]) assert.ok(isAt(viewer, `s${n}`, n), `s${n}: ${JSON.stringify(viewer.sensor(`s${n}`))}`);
  }
});
