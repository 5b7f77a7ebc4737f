// SPDX-License-Identifier: Apache-2.0
// Hubs that relay other hubs' rooms: what their viewers receive, the cost, and the effect of a hub on the way that is
// killed or hangs. More rounds for the cost:
// ROOMCAST_COST_ROUNDS=9 node --test tests/network/upstream.test.mjs
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { copyFileSync, writeFileSync } from 'node:fs';
import { connect, createServer } from 'node:net';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, run, scratchFolder } from '../cli/program.mjs';
import { makeToken } from './admin.mjs';
import { costFrames_bytes, costRoomsOption, costTimeout_ms, startCostSensors, tellCost } from './hub_cost.mjs';
import { RoomClient, SendingSensor } from './room_client.mjs';
import { assertMissedNothing, longestPause_ms } from './rooms.mjs';

const fps = 30;
const longestGap_ms = 1000;

async function startHub(t, ...options) {
  const data = options.includes('--data') ? [] : ['--data', scratchFolder(t)];
  const args = ['hub', '--listen', '127.0.0.1:0', '--threads', '1', '--no-align', ...data, ...options];
  const program = new Program(args, { limitMs: 60_000 + costTimeout_ms });
  t.after(() => program.stop('SIGKILL'));
  return { program, url: `ws://127.0.0.1:${await program.port()}` };
}

/** Starts a hub that relays these hubs. */
function startEdge(t, ...hubs) {
  return startHub(t, ...hubs.flatMap(({ url }) => ['--upstream', url]));
}

async function startSensors(t, hub, count, payloadBytes = 8000) {
  const options = { fps, payloadBytes };
  return Promise.all(
    Array.from({ length: count }, (_, n) => SendingSensor.start(t, hub.url, { name: `s${n}`, ...options })));
}

test('a_viewer_of_another_hub_sees_the_whole_room_and_the_relay_stops_without_viewers', async (t) => {
  const origin = await startHub(t);
  await startSensors(t, origin, 4);
  const witness = await RoomClient.join(t, origin.url);
  const edge = await startEdge(t, origin);
  await delay(300);
  assert.equal(witness.rosters.at(-1).viewers, 1, 'nobody watches at the edge: nothing is pulled');

  const viewer = await RoomClient.join(t, edge.url);
  await viewer.until('four sensors', () => [0, 1, 2, 3].every((n) => viewer.sensor(`s${n}`)?.online));
  const ids = [0, 1, 2, 3].map((n) => viewer.sensor(`s${n}`).id);
  await viewer.until('their frames', () => ids.every((id) => viewer.seqsOf(id).length > 60));
  assertMissedNothing(viewer, ids);
  const roomMinusHostNs = await viewer.askTime();
  const newest = viewer.sets.at(-1).frames.at(-1);
  const age_ms = Number(process.hrtime.bigint() + roomMinusHostNs - newest.captureNs) / 1e6;
  assert.ok(age_ms > -5 && age_ms < 1000, `captured ${age_ms} ms ago in the edge's time`);

  viewer.socket.terminate();
  await witness.until('it is pulled no more', () => witness.rosters.at(-1).viewers === 1);
});

/** A room relayed by two hubs, and a hub that relays either of these. */
async function chain(t) {
  const origin = await startHub(t);
  await startSensors(t, origin, 4);
  const [first, second] = [await startEdge(t, origin), await startEdge(t, origin)];
  const edge = await startEdge(t, first, second);
  const viewer = await RoomClient.join(t, edge.url);
  await viewer.moreSets(30);
  return { viewer, onTheWay: await relays(t, first) ? first : second };
}

/** True if a relaying hub is connected there. */
async function relays(t, hub) {
  const witness = await RoomClient.join(t, hub.url);
  await witness.until('who is there', () => witness.rosters.length > 0);
  witness.socket.terminate();
  return witness.rosters.at(-1).viewers === 2;
}

for (const [what, signal] of [['killed', 'SIGKILL'], ['hung', 'SIGSTOP']]) {
  test(`a_${what}_hub_on_the_way_is_replaced_by_the_next`, async (t) => {
    const { viewer, onTheWay } = await chain(t);
    viewer.sets.splice(0, viewer.sets.length - 1);
    onTheWay.program.child.kill(signal);
    await delay(longestGap_ms + 500);
    await viewer.moreSets(10);
    const gap_ms = longestPause_ms(viewer);
    t.diagnostic(`${what}: ${Math.round(gap_ms)} ms without a set`);
    assert.ok(gap_ms <= longestGap_ms, `${gap_ms} ms without a set`);
    await viewer.until('the sensors', () => [0, 1, 2, 3].every((n) => viewer.sensor(`s${n}`)?.online));
  });
}

test('a_client_of_several_hubs_joins_the_one_that_answers_first', async (t) => {
  const [near, far] = [await startHub(t), await startHub(t)];
  const slow = await startSlowWay(t, far, 150);
  for (const urls of [[slow.url, near.url], [near.url, slow.url]]) {
    const recorder = new Program(['record', `${scratchFolder(t)}/out.mcap`, '--hub', urls.join(','), '--seconds', '20']);
    t.after(() => recorder.stop('SIGKILL'));
    const witness = await RoomClient.join(t, near.url);
    await witness.until('the recorder', () => witness.rosters.at(-1)?.viewers === 2);
    await recorder.stop('SIGKILL');
    await witness.until('it has left', () => witness.rosters.at(-1).viewers === 1);
    witness.socket.terminate();
  }
  far.program.child.kill('SIGSTOP'); // it stops answering
  const recorder = new Program(['record', `${scratchFolder(t)}/out.mcap`, '--hub', `${far.url},${near.url}`, '--seconds', '20']);
  t.after(() => recorder.stop('SIGKILL'));
  const witness = await RoomClient.join(t, near.url);
  await witness.until('the recorder', () => witness.rosters.at(-1)?.viewers === 2);
});

/** A path to this hub with `delay_ms` of delay in each direction. */
async function startSlowWay(t, { url }, delay_ms) {
  const port = Number(new URL(url).port);
  const later = (from, to) => from.on('data', (bytes) => setTimeout(() => to.write(bytes), delay_ms)).on('close', () => to.destroy()).on('error', () => {});
  const server = createServer((client) => {
    const hub = connect(port, '127.0.0.1');
    later(client, hub);
    later(hub, client);
  }).listen(0, '127.0.0.1');
  await once(server, 'listening');
  t.after(() => server.close());
  return { url: `ws://127.0.0.1:${server.address().port}` };
}

test('when_the_token_of_a_hub_is_revoked_the_room_ends_for_all_behind_it', async (t) => {
  const [theirs, ours] = [scratchFolder(t), scratchFolder(t)];
  const { token, id } = await makeToken(theirs, '--room', 'room', '--role', 'hub');
  const { token: sensorToken } = await makeToken(theirs, '--room', 'room', '--role', 'sensor');
  writeFileSync(`${ours}/token`, token);
  const origin = await startHub(t, '--access', 'token', '--data', theirs);
  const edge = await startHub(t, '--upstream', origin.url, '--upstream-token-file', `${ours}/token`);
  await SendingSensor.start(t, origin.url, { name: 's0', fps, token: sensorToken });
  const viewer = await RoomClient.join(t, edge.url);
  await viewer.moreSets(10);
  await run('token', '--data', theirs, '--revoke', id);
  await viewer.until('the room has ended here', () => viewer.sensor('s0')?.online === false);
});

test('a_viewers_token_does_not_let_a_hub_relay', async (t) => {
  const [theirs, ours] = [scratchFolder(t), scratchFolder(t)];
  writeFileSync(`${ours}/token`, (await makeToken(theirs, '--room', 'room', '--role', 'viewer')).token);
  const origin = await startHub(t, '--access', 'token', '--data', theirs);
  const edge = await startHub(t, '--upstream', origin.url, '--upstream-token-file', `${ours}/token`);
  await RoomClient.join(t, edge.url);
  await edge.program.prints(/this token is for role viewer; to relay this room takes one for role hub/);
});

test('holders_of_a_revoked_token_are_disconnected_at_relays_too', async (t) => {
  const [theirs, ours, last] = [scratchFolder(t), scratchFolder(t), scratchFolder(t)];
  const [hubs, guests, others] = [
    await makeToken(theirs, '--room', 'room', '--role', 'hub'),
    await makeToken(theirs, '--room', 'room', '--role', 'viewer', '--name', 'Ada'),
    await makeToken(theirs, '--room', 'room', '--role', 'viewer'),
  ];
  for (const folder of [ours, last]) { // with the same secret, a token is valid at all of them
    copyFileSync(`${theirs}/hub.secret`, `${folder}/hub.secret`);
    writeFileSync(`${folder}/token`, hubs.token);
  }
  const origin = await startHub(t, '--access', 'token', '--data', theirs);
  const behind = (hub, folder) =>
    startHub(t, '--access', 'token', '--data', folder, '--upstream', hub.url, '--upstream-token-file', `${folder}/token`);
  const middle = await behind(origin, ours);
  const edge = await behind(middle, last);
  const stays = await RoomClient.join(t, edge.url, { token: others.token });
  const guest = await RoomClient.join(t, edge.url, { token: guests.token });
  await run('token', '--data', theirs, '--revoke', guests.id);
  assert.match((await guest.closed).reason, /revoked/);
  await assert.rejects(RoomClient.join(t, edge.url, { token: guests.token }), /revoked/);
  assert.equal(stays.end, undefined, 'who has another token stays');

  const late = await makeToken(theirs, '--room', 'room', '--role', 'viewer');
  stays.socket.terminate();
  await delay(4500); // without viewers, the hub does not subscribe upstream
  await run('token', '--data', theirs, '--revoke', late.id);
  const unknown = await RoomClient.join(t, edge.url, { token: late.token });
  assert.match((await unknown.closed).reason, /revoked/, 'as soon as the room is fetched again');
});

for (const payloadBytes of costFrames_bytes) {
  test(`what_it_costs_to_serve_a_room_on_with_frames_of_${payloadBytes}_bytes`, { timeout: 60_000 + costTimeout_ms }, async (t) => {
    const rooms = costRoomsOption(scratchFolder(t));
    const origin = await startHub(t, ...rooms);
    await startCostSensors(t, origin, payloadBytes);
    await tellCost(t, { origin, edge: await startHub(t, '--upstream', origin.url, ...rooms) });
  });
}
