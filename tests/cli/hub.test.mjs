// SPDX-License-Identifier: Apache-2.0
// The hub and its clients when the other side is missing, disconnects, or sends invalid data.
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { chownSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { createServer } from 'node:net';
import { networkInterfaces } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, assertFailed, assertServes, run, scratchFolder, startHub, startSensor } from './program.mjs';
import { RawSocket } from './raw_socket.mjs';
import { writeJoin } from '../network/messages.mjs';
import { RoomClient } from '../network/room_client.mjs';

/** A port of this machine without a listener. */
async function closedPort() {
  const server = createServer().listen(0, '127.0.0.1');
  await new Promise((resolve) => server.once('listening', resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

function getStatus(port, path) {
  return new Promise((resolve, reject) => {
    request({ host: '127.0.0.1', port, path }, (answer) => resolve(answer.resume().statusCode)).on('error', reject).end();
  });
}

/** A hub in use: a simulated sensor sends to it. */
async function startRoom(t) {
  const hub = await startHub(t);
  return { hub, sensor: await startSensor(t, hub) };
}

test('port_in_use_is_named', async (t) => {
  const hub = await startHub(t);
  assertFailed(await run('hub', '--listen', `127.0.0.1:${hub.port}`), 1, new RegExp(`${hub.port}.*in use`));
});

test('hub_stops_in_good_order_when_interrupted', async (t) => {
  const hub = await startHub(t);
  assert.equal(await hub.program.stop('SIGINT'), 0);
});

test('sensor_without_a_hub_names_the_address', async () => {
  const port = await closedPort();
  assertFailed(await run('sensor', '--source', 'sim', '--hub', `ws://127.0.0.1:${port}`), 1, new RegExp(`127.0.0.1:${port}`));
});

test('viewer_without_a_hub_names_the_address_and_writes_nothing', async (t) => {
  const port = await closedPort();
  const folder = scratchFolder(t);
  const result = await run('view', '--hub', `ws://127.0.0.1:${port}`, '--headless', '--png', join(folder, 'a.png'));
  assertFailed(result, 1, new RegExp(`127.0.0.1:${port}`));
  assert.deepEqual(readdirSync(folder), []);
});

test('a_server_that_is_no_hub_is_recognised', async (t) => {
  const server = createServer((socket) => socket.end('HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n'));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  t.after(() => server.close());
  const result = await run('sensor', '--source', 'sim', '--hub', `ws://127.0.0.1:${server.address().port}`);
  assertFailed(result, 1, /404.*is it a roomcast hub/);
});

test('sensor_outlives_its_hub_and_joins_the_next_one', async (t) => {
  const { hub, sensor } = await startRoom(t);
  await assertServes(t, hub);
  await hub.program.stop('SIGKILL');
  await sensor.prints(/trying again/);
  const next = new Program(['hub', '--listen', `127.0.0.1:${hub.port}`]);
  t.after(() => next.stop('SIGKILL'));
  await next.prints(/http/);
  await assertServes(t, hub);
});

const nonsense = {
  bytes_that_are_not_http: (socket) => socket.send(randomBytes(20_000)),
  endless_http_header: (socket) => socket.send('GET / HTTP/1.1\r\nX: ' + 'a'.repeat(100_000)),
  websocket_frames_at_random: async (socket) => {
    await socket.upgrade();
    socket.send(Buffer.concat([Buffer.from([0xff, 0xff]), randomBytes(4096)]));
  },
  message_that_is_not_roomcast: async (socket) => {
    await socket.upgrade();
    socket.sendMessage(randomBytes(300));
  },
  control_message_of_noise: async (socket) => {
    await socket.upgrade();
    socket.sendMessage(Buffer.concat([Buffer.from([0x52, 0x43, 1, 2]), randomBytes(300)]));
  },
  frame_before_joining: async (socket) => {
    await socket.upgrade();
    const header = Buffer.alloc(48);
    Buffer.from([0x52, 0x43, 1, 1, 48, 0]).copy(header);
    socket.sendMessage(header);
  },
};

test('hub_closes_connections_with_invalid_data_and_serves_the_others', async (t) => {
  for (const [name, talk] of Object.entries(nonsense)) {
    await t.test(name, async (t) => {
      const { hub } = await startRoom(t);
      const socket = await RawSocket.open(hub.port);
      t.after(() => socket.stream.destroy());
      await talk(socket);
      await socket.closed;
      assert.equal(await getStatus(hub.port, '/healthz'), 200);
      await assertServes(t, hub);
    });
  }
});

test('metrics_count_sensors_and_sets', async (t) => {
  const hub = await startHub(t);
  await startSensor(t, hub, '--always');
  const deadline = Date.now() + 10_000;
  let metrics = '';
  while (!/^roomcast_sets_total\{room="room"\} [1-9]/m.test(metrics)) {
    assert.ok(Date.now() < deadline, `no frame set was counted:\n${metrics}`);
    metrics = await (await fetch(`http://127.0.0.1:${hub.port}/metrics`)).text();
  }
  assert.match(metrics, /^roomcast_sensor_online\{room="room",sensor="[^"]+"\} 1$/m);
});

test('the_reason_of_a_close_is_a_sentence', async (t) => {
  const hub = await startHub(t);
  const socket = await RawSocket.open(hub.port);
  await socket.upgrade();
  socket.sendMessage(randomBytes(300));
  const { code, reason } = await socket.closeReason();
  assert.ok([1002, 1003, 1008].includes(code), `${code}`);
  assert.match(reason, /\w+ \w+/);
});

test('hub_that_cannot_read_its_database_does_not_start', async (t) => {
  const folder = scratchFolder(t);
  writeFileSync(join(folder, 'hub.sqlite'), 'x'.repeat(5000));
  assertFailed(await run('hub', '--listen', '127.0.0.1:0', '--data', folder), 1, /hub\.sqlite cannot be used/);
});

test('hub_on_all_addresses_names_those_of_its_machine', async (t) => {
  const own = Object.values(networkInterfaces()).flat().filter(({ internal, family }) => !internal && family === 'IPv4').map(({ address }) => address);
  const hub = new Program(['hub', '--listen', '0.0.0.0:0', '--no-align', '--data', scratchFolder(t)]);
  t.after(() => hub.stop('SIGKILL'));
  await hub.prints(/sha256=\w+\n/);
  assert.equal(await hub.stop(), 0);
  const [, named = ''] = /in its place: (.*)$/m.exec(hub.stdout) ?? [];
  assert.deepEqual(named.split(', ').sort(), own.length > 0 ? own.sort() : ['']);
});

test('strangers_write_no_lines_of_a_librarys_into_the_log', async (t) => {
  const hub = await startHub(t, '--log', 'json', '--verbose');
  for (const field of ['room', 'name', 'token', 'code']) {
    const client = await RoomClient.open(t, hub.url);
    const message = writeJoin({ room: 'room', name: 'name', [field]: 'no UTF-8: x' });
    message[message.indexOf('no UTF-8: x') + 'no UTF-8: x'.length - 1] = 0xff;
    client.send(message);
    assert.equal((await client.closed).code, 1008);
  }
  assert.equal(await hub.program.stop(), 0);
  for (const line of hub.program.stderr.trimEnd().split('\n')) JSON.parse(line);
});

test('hub_warns_when_it_runs_as_root', async (t) => {
  const isRoot = process.getuid() === 0;
  const { program } = await startHub(t);
  assert.equal(/runs as root without need/.test(program.stderr), isRoot, program.stderr);
  if (!isRoot) return;
  const folder = scratchFolder(t);
  chownSync(folder, 65534, 65534);
  const through = ['setpriv', '--reuid=65534', '--regid=65534', '--clear-groups'];
  const nobodys = new Program(['hub', '--listen', '127.0.0.1:0', '--data', folder], { through });
  t.after(() => nobodys.stop('SIGKILL'));
  await nobodys.port();
  assert.doesNotMatch(nobodys.stderr, /root/);
});

test('service_of_the_hub_has_no_privileges_and_writes_its_own_folder_only', () => {
  const unit = readFileSync(new URL('../../packaging/systemd/roomcast-hub.service', import.meta.url), 'utf8');
  const settings = unit.split('\n');
  for (const setting of ['DynamicUser=yes', 'StateDirectory=roomcast', 'StateDirectoryMode=0700', 'ProtectSystem=strict',
    'ProtectHome=yes', 'PrivateTmp=yes', 'NoNewPrivileges=yes', 'CapabilityBoundingSet=CAP_NET_BIND_SERVICE']) {
    assert.ok(settings.includes(setting), setting);
  }
  assert.ok(!/^(ReadWritePaths|User|AmbientCapabilities)=/m.test(unit), 'nothing is opened again');
});
