// SPDX-License-Identifier: Apache-2.0
// Access to a hub's rooms by tokens, with the real programs.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, assertFailed, assertServes, run, scratchFolder, startHub } from './program.mjs';

async function startClosedHub(t) {
  const folder = scratchFolder(t);
  const hub = await startHub(t, '--access', 'token', '--data', folder, '--verbose');
  return { ...hub, folder };
}

async function token(hub, ...options) {
  const { code, stdout, stderr } = await run('token', '--data', hub.folder, '--json', ...options);
  assert.equal(code, 0, stderr);
  return JSON.parse(stdout);
}

async function startSensor(t, hub, ...options) {
  const sensor = new Program(['sensor', '--source', 'sim', '--hub', hub.url, '--verbose', ...options]);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  return sensor;
}

const look = (hub, folder, ...options) =>
  run('view', '--hub', hub.url, '--headless', '--size', '64,48', '--png', join(folder, 'room.png'), ...options);

test('room_is_visible_only_with_tokens', async (t) => {
  const hub = await startClosedHub(t);
  const { token: forSensor } = await token(hub, '--room', 'room', '--role', 'sensor');
  const { token: forViewer } = await token(hub, '--room', 'room', '--role', 'viewer');
  const file = join(hub.folder, 'sensor.token');
  writeFileSync(file, `${forSensor}\n`, { mode: 0o600 });
  await startSensor(t, hub, '--token-file', file);
  const seen = await look(hub, hub.folder, '--token', forViewer);
  assert.equal(seen.code, 0, seen.stderr);
  assertFailed(await look(hub, hub.folder), 1, /takes a token for role viewer/);
  assertFailed(await look(hub, hub.folder, '--token', forSensor), 1, /is for role sensor/);
  assertFailed(await look(hub, hub.folder, '--token', `${forViewer}x`), 1, /has not issued this token/);
  assertFailed(await look(hub, hub.folder, '--room', 'attic', '--token', forViewer), 1, /another room/);
});

test('a_code_works_once', async (t) => {
  const hub = await startClosedHub(t);
  await startSensor(t, hub, '--token', (await token(hub, '--room', 'room', '--role', 'sensor')).token);
  const made = await token(hub, '--room', 'room', '--role', 'viewer', '--link', 'https://hub.example.org:7600');
  assert.match(made.link, /^https:\/\/hub\.example\.org:7600\/#room=room&code=[0-9A-Z-]{19}$/);
  assert.equal((await look(hub, hub.folder, '--token', made.code)).code, 0);
  assertFailed(await look(hub, hub.folder, '--token', made.code), 1, /used already/);
});

test('unused_code_is_listed_and_revoked', async (t) => {
  const hub = await startClosedHub(t);
  const made = await token(hub, '--room', 'room', '--role', 'viewer', '--link', 'https://hub.example.org:7600');
  const { tokens } = await token(hub, '--list');
  assert.deepEqual(tokens.map(({ id, once, revoked }) => ({ id, once, revoked })), [{ id: made.id, once: true, revoked: false }]);
  assert.match((await run('token', '--data', hub.folder, '--list')).stdout, /code, (59m|1h)/);
  assert.equal((await run('token', '--data', hub.folder, '--revoke', made.id)).code, 0);
  assertFailed(await look(hub, hub.folder, '--token', made.code), 1, /code was revoked/);
});

test('revoked_token_disconnects_its_holder_and_is_refused', async (t) => {
  const hub = await startClosedHub(t);
  const { id, token: shown } = await token(hub, '--room', 'room', '--role', 'sensor');
  const sensor = await startSensor(t, hub, '--token', shown);
  assert.equal((await run('token', '--data', hub.folder, '--revoke', id)).code, 0);
  assert.equal(await sensor.ended, 1);
  assert.match(sensor.stderr, /revoked/);
  const { tokens } = await token(hub, '--list');
  assert.equal(tokens.find((entry) => entry.id === id).revoked, true);
});

test('hub_on_this_machine_is_open_and_protects_its_secret', async (t) => {
  const folder = scratchFolder(t);
  const hub = await startHub(t, '--data', folder);
  await startSensor(t, hub);
  await assertServes(t, hub);
  assert.equal(statSync(join(folder, 'hub.secret')).mode & 0o777, 0o600);
});

test('qr_code_is_drawn', async (t) => {
  const options = ['--room', 'lab', '--role', 'viewer', '--link', 'hub.example.org', '--qr'];
  const { code, stdout } = await run('token', '--data', scratchFolder(t), ...options);
  assert.equal(code, 0);
  assert.match(stdout, /█▀|▀█/);
});

test('room_that_is_configured_is_there_again_and_so_is_not_closed', async (t) => {
  const hub = await startClosedHub(t);
  const { token: admin } = await token(hub, '--role', 'admin');
  const close = (room) =>
    fetch(`http://127.0.0.1:${hub.port}/api/v1/rooms/${room}`, { method: 'DELETE', headers: { Authorization: `Bearer ${admin}` } });
  const refused = await close('room');
  assert.equal(refused.status, 409);
  assert.match((await refused.json()).error.sentence, /in the hub's configuration/);
});

const mistakes = {
  no_role: [['--room', 'lab'], /--role/],
  no_room: [['--role', 'viewer'], /--room/],
  no_time: [['--role', 'viewer', '--room', 'lab', '--ttl', 'long'], /30m/],
  too_long: [['--role', 'viewer', '--room', 'lab', '--ttl', '9999d'], /ten years/],
};
for (const [name, [options, sentence]] of Object.entries(mistakes)) {
  test(`token_with_${name}_is_one_sentence`, async (t) => {
    assertFailed(await run('token', '--data', scratchFolder(t), ...options), 2, sentence);
  });
}

test('token_file_is_readable_by_its_user_only_and_is_a_new_one', async (t) => {
  const hub = await startClosedHub(t);
  const file = join(hub.folder, 'ada.token');
  const make = (...options) => run('token', '--data', hub.folder, '--room', 'room', '--role', 'viewer', '--out', file, ...options);
  assert.deepEqual(await make(), { code: 0, stdout: '', stderr: '' });
  assert.equal(statSync(file).mode & 0o777, 0o600);
  const { stderr } = await look(hub, hub.folder, '--token-file', file);
  assert.match(stderr, /no sensor has joined/, 'the token is valid');
  assertFailed(await make(), 1, /ada\.token: File exists/);
  const { tokens } = await token(hub, '--list');
  assert.deepEqual(tokens.map(({ revoked }) => revoked).sort(), [false, true], 'a token that nobody has is revoked');
  assertFailed(await make('--list'), 2, /--out|--list/);
});

test('token_for_a_room_that_a_hub_does_not_know_warns', async (t) => {
  const folder = scratchFolder(t);
  const make = (...options) => run('token', '--data', folder, '--role', 'viewer', ...options);
  assert.equal((await make('--room', 'room')).code, 0);
  const lab = await make('--room', 'lab');
  assert.equal(lab.code, 0, lab.stderr);
  assert.match(lab.stdout, /^\S+\n$/);
  assert.match(lab.stderr, /^roomcast token: no room "lab" is in this hub's configuration.* it has "room"/);
  const config = join(folder, 'roomcast.toml');
  writeFileSync(config, '[[room]]\nname = "lab"\n');
  assert.equal((await make('--room', 'lab', '--config', config)).stderr, '');
});

test('token_that_is_not_there_cannot_be_revoked', async (t) => {
  const folder = scratchFolder(t);
  assert.equal((await run('token', '--data', folder, '--role', 'admin')).code, 0);
  assertFailed(await run('token', '--data', folder, '--revoke', 'nobodys'), 1, /no token "nobodys"/);
});

test('tokens_are_looked_for_only_where_a_hub_has_its_secret', async (t) => {
  const folder = scratchFolder(t);
  for (const what of [['--list'], ['--revoke', 'nobodys']]) {
    assertFailed(await run('token', '--data', folder, ...what), 1, /no hub's secret is in .*--data/);
  }
  assert.deepEqual(readdirSync(folder), []);
});

test('token_belongs_to_the_hub_named_by_configuration_or_environment', async (t) => {
  const folder = scratchFolder(t);
  const inFolder = (name) => join(folder, name);
  writeFileSync(inFolder('roomcast.toml'), `data = "${inFolder('configured')}"\n`);
  const make = (options, environment = {}) => run('token', '--role', 'admin', ...options, { environment });
  const secretOf = (name) => readFileSync(join(inFolder(name), 'hub.secret')).toString('hex');

  const made = await make(['--config', inFolder('roomcast.toml')]);
  assert.equal(made.code, 0, made.stderr);
  assert.ok(made.stderr.includes(`a new one was made: only a hub with --data ${inFolder('configured')} accepts`), made.stderr);
  assert.equal((await make(['--config', inFolder('roomcast.toml')])).stderr, '', 'it is there by now');
  await make(['--config', inFolder('roomcast.toml')], { ROOMCAST_HUB_DATA: inFolder('environment') });
  await make(['--config', inFolder('roomcast.toml'), '--data', inFolder('said')], { ROOMCAST_HUB_DATA: inFolder('environment') });
  assert.equal(new Set(['configured', 'environment', 'said'].map(secretOf)).size, 3);
  assertFailed(await make(['--config', inFolder('none.toml')]), 1, /none\.toml/);
});

test('configuration_is_checked_with_the_files_that_it_names_and_nothing_is_made', async (t) => {
  const folder = scratchFolder(t);
  const file = join(folder, 'file');
  writeFileSync(file, 'neither a folder nor a certificate');
  const secret = join(folder, 'hub.secret');
  const checked = (...options) => run('hub', '--check', ...(options.includes('--data') ? [] : ['--data', join(folder, 'new')]), ...options);
  assertFailed(await checked('--tls-cert', '/no/such.pem', '--tls-key', '/no/such.key'), 1, /such\.pem/);
  assertFailed(await checked('--tls-cert', file, '--tls-key', file), 1, /no certificate/);
  assertFailed(await checked('--tls-cert', file), 2, /--tls-key/);
  assertFailed(await checked('--tls-key', file), 2, /--tls-cert/);
  assertFailed(await checked('--tls-self-signed', '--tls-cert', file, '--tls-key', file), 2, /either/);
  assertFailed(await checked('--data', join(file, 'data')), 1, /file is no folder/);
  assertFailed(await checked('--recordings', file), 1, /file is no folder/);
  assertFailed(await checked('--web', join(folder, 'page')), 1, /page/);
  assertFailed(await checked('--public-url', 'ftp://hub'), 2, /public_url/);
  const made = await checked('--tls-self-signed');
  assert.equal(made.code, 0, made.stderr);
  assert.deepEqual(readdirSync(folder), ['file']);
  writeFileSync(secret, 'password', { mode: 0o600 });
  assertFailed(await checked('--data', folder), 1, /hub\.secret is not a hub's secret/);
});

test('configuration_is_checked', async (t) => {
  const file = join(scratchFolder(t), 'roomcast.toml');
  writeFileSync(file, '[[room]]\nname = "lab"\n');
  const good = await run('hub', '--config', file, '--check');
  assert.equal(good.code, 0, good.stderr);
  assert.match(good.stdout, /lab/);
  writeFileSync(file, '[[room]]\nname = "lab"\nveiw = "token"\n');
  assertFailed(await run('hub', '--config', file, '--check'), 2, /roomcast\.toml: a room has no setting "veiw" \(line 1\)/);
});
