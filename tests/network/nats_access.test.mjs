// SPDX-License-Identifier: Apache-2.0
// Access control of the hubs' NATS servers (passwords, credentials, TLS), and a hub's message when access is denied.
import assert from 'node:assert/strict';
import { copyFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { assertFailed, run, scratchFolder, startHub } from '../cli/program.mjs';
import { ask, makeToken } from './admin.mjs';
import { makeCertificate } from './certificate.mjs';
import { natsIsMissing, startNode } from './nats.mjs';
import { newAccount } from './nats_credentials.mjs';
import { RoomClient, SendingSensor } from './room_client.mjs';

const skip = natsIsMissing;

/** Asserts that two hubs with these options see each other's sensors. */
async function assertTheyShareARoom(t, ...options) {
  const hubs = [await startHub(t, '--no-align', ...options), await startHub(t, '--no-align', ...options)];
  await SendingSensor.start(t, hubs[0].url, { name: 's0', fps: 30 });
  const viewer = await RoomClient.join(t, hubs[1].url);
  await viewer.moreSets(10);
}

async function assertRefused(t, sentence, ...options) {
  assertFailed(await run('hub', '--listen', '127.0.0.1:0', '--data', scratchFolder(t), ...options), 1, sentence);
}

test('a_server_with_a_password_accepts_hubs_that_have_it', { skip }, async (t) => {
  const node = await startNode(t, { more: 'authorization { user: hub, password: right }' });
  const withSecret = (secret) => node.url.replace('//', `//${secret}@`);
  await assertTheyShareARoom(t, '--nats', withSecret('hub:right'));
  await assertRefused(t, /refuses this hub; name its credentials/, '--nats', node.url);
  await assertRefused(t, /refuses this hub/, '--nats', withSecret('hub:wrong'));
});

test('a_server_with_accounts_accepts_hubs_with_credentials', { skip }, async (t) => {
  const [account, another] = [newAccount(), newAccount()];
  const node = await startNode(t, { more: account.config });
  const folder = scratchFolder(t);
  const file = (name, text) => (writeFileSync(join(folder, name), text), join(folder, name));
  await assertTheyShareARoom(t, '--nats', node.url, '--nats-credentials', file('hub.creds', account.credentials));
  await assertRefused(t, /refuses this hub; name its credentials/, '--nats', node.url);
  await assertRefused(t, /refuses the credentials in .*other\.creds/, '--nats', node.url, '--nats-credentials', file('other.creds', another.credentials));
  await assertRefused(t, /none\.creds/, '--nats', node.url, '--nats-credentials', file('none.creds', 'nothing'));
});

test('an_encrypted_server_is_trusted_when_its_certificate_is', { skip }, async (t) => {
  const { file } = await makeCertificate(t, scratchFolder(t));
  const another = await makeCertificate(t, scratchFolder(t));
  const node = await startNode(t, { scheme: 'tls', more: `tls { cert_file: "${file}", key_file: "${file}" }` });
  await assertTheyShareARoom(t, '--nats', node.url, '--nats-ca', file);
  await assertRefused(t, /certificate is not trusted/, '--nats', node.url);
  await assertRefused(t, /certificate is not trusted/, '--nats', node.url, '--nats-ca', another.file);
  await assertRefused(t, /certificate is not trusted/, '--nats', node.url.replace('tls:', 'nats:'));
});

test('an_unencrypted_server_is_refused_where_encryption_is_required', { skip }, async (t) => {
  const node = await startNode(t);
  await assertRefused(t, /offers no TLS/, '--nats', node.url.replace('nats:', 'tls:'));
});

test('the_configuration_is_checked_without_a_server', async () => {
  assertFailed(await run('hub', '--check', '--nats', 'http://a:1'), 2, /is no NATS address/);
  assertFailed(await run('hub', '--check', '--nats', 'nats://a:1', '--nats-credentials', '/no/such/file'), 1, /cannot read \/no\/such\/file/);
  assertFailed(await run('hub', '--check', '--nats', 'nats://a:1', '--nats-cert', '/etc/hostname'), 2, /needs its key/);
  assertFailed(await run('hub', '--check', '--nats', 'nats://a:1', '--upstream', 'ws://b'), 2, /exclude each other/);
  assertFailed(await run('hub', '--check', '--nats', 'nats://a:1', '--public-url', 'a b'), 2, /a b/);
  assert.equal((await run('hub', '--check', '--nats', 'nats://a:1,tls://b')).code, 0);
});

/** Two hubs with one secret, so that a token is valid at both, over one server. */
async function startTwins(t) {
  const node = await startNode(t);
  const folders = [scratchFolder(t), scratchFolder(t)];
  await makeToken(folders[0], '--role', 'admin');
  copyFileSync(join(folders[0], 'hub.secret'), join(folders[1], 'hub.secret'));
  const options = ['--no-align', '--access', 'token', '--nats', node.url];
  const hubs = await Promise.all(folders.map((folder) => startHub(t, ...options, '--data', folder)));
  return { folders, hubs };
}

const tokenFor = (folder, role) => makeToken(folder, '--room', 'room', '--role', role);

test('a_sensors_name_cannot_be_used_at_another_hub', { skip }, async (t) => {
  const { folders, hubs } = await startTwins(t);
  const [own, anothers, viewers] = [await tokenFor(folders[0], 'sensor'), await tokenFor(folders[0], 'sensor'), await tokenFor(folders[0], 'viewer')];
  const sensor = { fps: 30 };
  const here = await RoomClient.join(t, hubs[0].url, { name: 's0', sensor, token: own.token });
  const viewer = await RoomClient.join(t, hubs[1].url, { token: viewers.token });
  await viewer.until('the sensor', () => viewer.sensor('s0')?.online);
  await assert.rejects(RoomClient.join(t, hubs[1].url, { name: 's0', sensor, token: anothers.token }), /another sensor is here/);
  assert.equal(here.end, undefined, 'who was there stays');
  await RoomClient.join(t, hubs[1].url, { name: 's0', sensor, token: own.token });
  await here.closed; // the viewer has moved to the other hub by itself
});

test('a_token_revoked_at_one_hub_is_refused_by_the_other_and_its_holder_disconnected', { skip }, async (t) => {
  const { folders, hubs } = await startTwins(t);
  const { token, id } = await tokenFor(folders[0], 'viewer');
  const viewer = await RoomClient.join(t, hubs[1].url, { token });
  assert.equal((await run('token', '--data', folders[0], '--revoke', id)).code, 0);
  await viewer.closed;
  await assert.rejects(RoomClient.join(t, hubs[1].url, { token }), /revoked/);
});

test('only_admins_of_a_hub_get_the_list_of_hubs', { skip }, async (t) => {
  const { folders, hubs } = await startTwins(t);
  const admin = await makeToken(folders[0], '--role', 'admin');
  const guest = await tokenFor(folders[0], 'viewer');
  await RoomClient.join(t, hubs[1].url, { token: guest.token });
  const list = async (token) => (await ask(hubs[0].port, token, 'GET', '/hubs'));
  for (let tries = 0; (await list(admin.token)).body.hubs[1]?.rooms[0]?.viewers !== 1; ++tries) {
    assert.ok(tries < 200, JSON.stringify((await list(admin.token)).body));
  }
  const [own, other] = (await list(admin.token)).body.hubs;
  assert.notEqual(own.id, other.id);
  assert.deepEqual(other.rooms, [{ name: 'room', sensors: 0, viewers: 1 }]);
  assert.equal((await list(guest.token)).status, 403);
  assert.equal((await list()).status, 401);
});
