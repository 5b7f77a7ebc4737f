// SPDX-License-Identifier: Apache-2.0
// The commands of docs/guides/operation.md, and what programs of different wire versions say to each other.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, utimesSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { Program, assertFailed, run, scratchFolder, startHub } from './program.mjs';

const require = createRequire(new URL('../../web/package.json', import.meta.url));
const { WebSocket, WebSocketServer } = require('ws');

const guide = readFileSync(resolve(dirname(fileURLToPath(import.meta.url)), '../../docs/guides/operation.md'), 'utf8');

/** The lines of the guide's block after this heading, for this hub's folder. */
function commandsUnder(heading, data) {
  const [, block] = new RegExp(`## ${heading}\\n[^]*?\`\`\`\\n([^]*?)\`\`\``).exec(guide);
  return block.replaceAll('/var/lib/roomcast', data).split('\n').map((line) => line.replace(/ +#.*/, ''));
}

function shell(folder, lines) {
  const { status, stderr } = spawnSync('sh', ['-ec', lines.join('\n')], { cwd: folder, encoding: 'utf8', timeout: 20_000 });
  assert.equal(status, 0, stderr);
}

const noSqlite = spawnSync('sqlite3', ['--version']).error ? 'sqlite3 is not installed' : false;
const look = (hub, ...options) => run('view', '--hub', hub.url, '--size', '64,48', '--png', '/dev/null', ...options);

async function token(data, ...options) {
  const { code, stdout, stderr } = await run('token', '--data', data, '--json', ...options);
  assert.equal(code, 0, stderr);
  return JSON.parse(stdout);
}

async function addSensor(t, hub, token, name, ...options) {
  const sensor = new Program(['sensor', '--source', 'sim', '--hub', hub.url, '--verbose', '--name', name, '--token', token, ...options]);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  return sensor;
}

/** IDs of the sensors by name, as a viewer is told. */
async function idsOf(hub, token) {
  const admin = await fetch(`${hub.url.replace('ws', 'http')}/api/v1/rooms/room/sensors`, { headers: { authorization: `Bearer ${token}` } });
  const { sensors } = await admin.json();
  return Object.fromEntries(sensors.map(({ name, id }) => [name, id]));
}

test('a_hub_that_was_restored_from_a_running_hubs_backup_goes_on', { skip: noSqlite }, async (t) => {
  const folder = scratchFolder(t);
  const data = join(folder, 'data');
  const hub = await startHub(t, '--access', 'token', '--data', data);
  mkdirSync(join(data, 'recordings'), { recursive: true });
  const forSensor = (await token(data, '--room', 'room', '--role', 'sensor')).token;
  const forViewer = (await token(data, '--room', 'room', '--role', 'viewer')).token;
  const admin = (await token(data, '--role', 'admin')).token;
  const revoked = await token(data, '--room', 'room', '--role', 'viewer');
  assert.equal((await run('token', '--data', data, '--revoke', revoked.id)).code, 0);
  for (const name of ['b', 'a']) await addSensor(t, hub, forSensor, name);
  const ids = await idsOf(hub, admin);
  shell(folder, commandsUnder('Backup', data).filter((line) => !line.includes('self-signed.pem')));
  const late = (await token(data, '--room', 'room', '--role', 'viewer')).token; // after the backup
  await hub.program.stop('SIGKILL');

  shell(folder, commandsUnder('Restore', data).filter((line) => !line.startsWith('roomcast')).map((line) => line.replace(/ \S*self-signed\.pem/, '')));
  const again = await startHub(t, '--access', 'token', '--data', join(folder, 'restored'));
  for (const name of ['a', 'b']) await addSensor(t, again, forSensor, name);
  assert.deepEqual(await idsOf(again, admin), ids, 'sensors keep their IDs');
  const seen = await look(again, '--token', forViewer);
  assert.equal(seen.code, 0, seen.stderr);
  assertFailed(await look(again, '--token', revoked.token), 1, /revoked/);
  assert.equal((await look(again, '--token', late)).code, 0, 'the secret signed it');
  const { tokens } = await token(join(folder, 'restored'), '--list');
  assert.ok(tokens.length >= 4);
});

test('recordings_are_deleted_when_they_are_older_than_configured', async (t) => {
  const folder = scratchFolder(t);
  const first = await startHub(t);
  const sensor = new Program(['sensor', '--source', 'sim', '--hub', first.url, '--verbose']);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  const recordings = join(folder, 'recordings');
  mkdirSync(recordings, { mode: 0o700 });
  const recorded = await run('record', join(recordings, 'new.mcap'), '--hub', first.url, '--seconds', '0.5');
  assert.equal(recorded.code, 0, recorded.stderr);
  const before = new Date(Date.now() - 40 * 86_400_000);
  copyFileSync(join(recordings, 'new.mcap'), join(recordings, 'old.mcap'));
  writeFileSync(join(recordings, 'foreign.mcap'), 'no recording');
  for (const name of ['old', 'foreign']) utimesSync(join(recordings, `${name}.mcap`), before, before);

  const config = join(folder, 'roomcast.toml');
  writeFileSync(config, `recordings = "${recordings}"\n[limits]\nrecordings_days = 30\nrecordings_gb = 1\n`);
  const hub = await startHub(t, '--config', config, '--verbose');
  await hub.program.prints(/deleted the recording old/);
  assert.deepEqual(readdirSync(recordings).sort(), ['foreign.mcap', 'new.mcap']);
  assert.equal(await hub.program.stop(), 0, 'the hub does not wait for its next look');
  copyFileSync(join(recordings, 'new.mcap'), join(recordings, 'old.mcap'));
  utimesSync(join(recordings, 'old.mcap'), before, before);
  writeFileSync(config, `recordings = "${recordings}"\n[limits]\nrecordings_days = 1000\n[[room]]\nname = "room"\nrecordings_days = 30\n`);
  const other = await startHub(t, '--config', config, '--verbose');
  await other.program.prints(/deleted the recording old/);
  assert.equal(await other.program.stop(), 0);
  writeFileSync(config, '[limits]\nrecordings_days = -1\n');
  assertFailed(await run('hub', '--check', '--config', config), 2, /limits\.recordings_days is 0 to 1000000/);
});

test('an_older_hub_refuses_the_database_of_a_later_one', { skip: noSqlite }, async (t) => {
  const data = mkdtempSync(join(scratchFolder(t), 'data-'));
  const hub = await startHub(t, '--data', data);
  await hub.program.stop();
  shell(data, ['sqlite3 hub.sqlite "PRAGMA user_version = 1000"']);
  assertFailed(await run('hub', '--listen', '127.0.0.1:0', '--data', data), 1, /a later roomcast wrote it/);
});

test('a_hub_tells_a_client_of_another_version_what_it_speaks', async (t) => {
  const hub = await startHub(t);
  const socket = new WebSocket(`${hub.url}/ws`, ['roomcast.v2']);
  const answer = await new Promise((resolved) => {
    socket.on('error', () => {});
    socket.on('unexpected-response', (_, response) => {
      let text = '';
      response.setEncoding('utf8').on('data', (part) => (text += part)).on('end', () => resolved({ status: response.statusCode, text }));
    });
  });
  assert.deepEqual(answer, { status: 400, text: 'The WebSocket subprotocol must be roomcast.v1.\n' });
});

/** A hub of another version: it agrees to any subprotocol, or to none. */
async function strangeHub(t, handleProtocols) {
  const http = createServer();
  const server = new WebSocketServer({ server: http, handleProtocols });
  await new Promise((resolved) => http.listen(0, '127.0.0.1', resolved));
  t.after(() => {
    server.clients.forEach((client) => client.terminate());
    http.close();
  });
  return { server, url: `ws://127.0.0.1:${http.address().port}` };
}

for (const [name, command] of Object.entries({
  sensor: ['sensor', '--source', 'sim'],
  viewer: ['view', '--png', '/dev/null'],
  recorder: ['record', '/tmp/never.mcap'],
})) {
  test(`a_${name}_says_that_a_hub_speaks_another_version`, async (t) => {
    const { url } = await strangeHub(t, () => false);
    assertFailed(await run(...command, '--hub', url), 1, /does not speak roomcast\.v1/);
  });
}

test('a_hub_closes_on_a_message_of_another_version_with_a_sentence', async (t) => {
  const hub = await startHub(t);
  const socket = new WebSocket(`${hub.url}/ws`, ['roomcast.v1']);
  t.after(() => socket.terminate());
  socket.on('open', () => socket.send(Buffer.from([0x52, 0x43, 9, 2])));
  const reason = await new Promise((resolved) => socket.on('close', (_, text) => resolved(text.toString())));
  assert.match(reason, /roomcast version 9 is not supported, only version 1/);
});
