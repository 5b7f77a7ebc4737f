// SPDX-License-Identifier: Apache-2.0
// A hub that is killed while admins write: all acknowledged writes are present after a restart.
// More kills: ROOMCAST_KILLS=200 node --test tests/network/killed_writes.test.mjs
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, scratchFolder } from '../cli/program.mjs';
import { ask, makeToken } from './admin.mjs';

const kills = Number(process.env.ROOMCAST_KILLS ?? 4);
const killWithin_ms = 120;
const unansweredFor_ms = 1000;

async function startHub(t, data) {
  const hub = new Program(['hub', '--listen', '127.0.0.1:0', '--no-align', '--data', data]);
  t.after(() => hub.stop('SIGKILL'));
  return { hub, port: await hub.port() };
}

/** One admin who makes tokens, revokes every second one, and opens and changes rooms, as fast as the hub answers. */
async function writeUntilKilled(port, admin, kept, who) {
  for (let n = 0; ; ++n) {
    const made = await ask(port, admin, 'POST', '/tokens', { room: 'room', role: 'viewer', name: who });
    assert.equal(made.status, 201);
    kept.tokens.set(made.body.id, false);
    if (n % 2 === 0) {
      kept.tokens.set(made.body.id, 'perhaps');
      assert.equal((await ask(port, admin, 'DELETE', `/tokens/${made.body.id}`)).status, 204);
      kept.tokens.set(made.body.id, true);
    }
    const name = `${who} ${n}`;
    assert.equal((await ask(port, admin, 'POST', '/rooms', { name })).status, 201);
    kept.rooms.add(name);
  }
}

async function assertNothingLost(port, admin, kept) {
  const tokens = (await ask(port, admin, 'GET', '/tokens')).body.tokens;
  const revoked = new Map(tokens.map((token) => [token.id, token.revoked]));
  for (const [id, isRevoked] of kept.tokens) {
    assert.ok(revoked.has(id), `token ${id} was acknowledged and is gone`);
    if (isRevoked !== 'perhaps') assert.equal(revoked.get(id), isRevoked, `token ${id}`);
  }
  const rooms = new Set((await ask(port, admin, 'GET', '/rooms')).body.rooms.map(({ name }) => name));
  for (const name of kept.rooms) assert.ok(rooms.has(name), `room ${name} was acknowledged and is gone`);
}

test('changes_acknowledged_by_a_killed_hub_are_not_lost', { timeout: 30_000 + 3_000 * kills }, async (t) => {
  const folder = scratchFolder(t);
  let acknowledged = 0;
  for (let round = 0; round < kills; ++round) {
    const data = join(folder, `data${round}`);
    const token = (await makeToken(data, '--role', 'admin')).token;
    const kept = { tokens: new Map(), rooms: new Set() };
    const { hub, port } = await startHub(t, data);
    const writers = ['a', 'b', 'c'].map((who) =>
      writeUntilKilled(port, token, kept, who).catch((error) => {
        if (error instanceof assert.AssertionError) throw error; // otherwise the hub is gone
      }),
    );
    await delay(Math.random() * killWithin_ms);
    await hub.stop('SIGKILL');
    await Promise.race([Promise.all(writers), delay(unansweredFor_ms)]); // some requests never complete
    const next = await startHub(t, data);
    await assertNothingLost(next.port, token, kept);
    await next.hub.stop('SIGKILL');
    acknowledged += kept.tokens.size + kept.rooms.size;
  }
  t.diagnostic(`${kills} kills, ${acknowledged} acknowledged writes, none lost`);
  assert.ok(acknowledged > 0);
});
