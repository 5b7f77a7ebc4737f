// SPDX-License-Identifier: Apache-2.0
// `roomcast foxglove` read by another WebSocket library (npm ws) with nothing but what the server advertises, and compared
// with what Python receives of the same room.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';

import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, assertFailed, binary, run, scratchFolder, startHub, startSensor } from './program.mjs';

const require = createRequire(new URL('../../web/package.json', import.meta.url));
const WebSocket = require('ws');
const { createFileRegistry, fromBinary } = require('@bufbuild/protobuf');
const { FileDescriptorSetSchema } = require('@bufbuild/protobuf/wkt');

/** A client of foxglove.websocket.v1: `messages` are those of topics, decoded by the advertised schemas. */
class FoxgloveClient {
  channels = new Map();
  statuses = [];
  messages = [];

  static async connect(t, url, { origin } = {}) {
    const client = new FoxgloveClient();
    client.socket = new WebSocket(url, ['foxglove.websocket.v1'], { origin });
    t.after(() => client.socket.terminate());
    client.socket.on('message', (data, isBinary) => (isBinary ? client.takeData(data) : client.takeText(JSON.parse(data))));
    await once(client.socket, 'open');
    assert.equal(client.socket.protocol, 'foxglove.websocket.v1');
    return client;
  }

  takeText(message) {
    if (message.op === 'serverInfo') this.info = message;
    if (message.op === 'status') this.statuses.push(message);
    if (message.op === 'unadvertise') message.channelIds.forEach((id) => this.channels.delete(id));
    for (const channel of message.op === 'advertise' ? message.channels : []) {
      assert.equal(channel.encoding, 'protobuf');
      const files = fromBinary(FileDescriptorSetSchema, Buffer.from(channel.schema, 'base64'));
      this.channels.set(channel.id, { ...channel, type: createFileRegistry(files).getMessage(channel.schemaName) });
    }
  }

  takeData(data) {
    assert.equal(data[0], 1);
    const channel = this.channels.get(data.readUInt32LE(1) - 100); // as in subscribe()
    this.messages.push({ topic: channel.topic, time: data.readBigUInt64LE(5), content: fromBinary(channel.type, data.subarray(13)) });
  }

  topics() {
    return [...this.channels.values()].map(({ topic }) => topic).sort();
  }

  subscribe(...topics) {
    const wanted = [...this.channels.values()].filter(({ topic }) => topics.includes(topic));
    assert.equal(wanted.length, topics.length, `${topics} of ${this.topics()}`);
    this.say({ op: 'subscribe', subscriptions: wanted.map(({ id }) => ({ id: id + 100, channelId: id })) });
  }

  say(message) {
    this.socket.send(JSON.stringify(message));
  }

  of(topic) {
    return this.messages.filter((message) => message.topic === topic);
  }

  async until(what, condition) {
    for (const end = Date.now() + 20_000; !condition(); ) {
      assert.ok(Date.now() < end, `never came: ${what}; topics ${this.topics()}; ${JSON.stringify(this.statuses)}`);
      await new Promise((resolved) => setTimeout(resolved, 20));
    }
  }
}

/** Starts the server on a free port; `{ program, url }`. */
async function startFoxglove(t, hub, ...options) {
  const program = new Program(['foxglove', '--hub', hub.url, '--port', '0', '--json', ...options]);
  t.after(() => program.stop('SIGKILL'));
  const [line] = await program.prints(/^\{.*\}$/m);
  return { program, url: JSON.parse(line).url };
}

async function startSmallRoom(t) {
  const hub = await startHub(t);
  const rig = writeSmallRig(scratchFolder(t));
  for (const sensor of ['s0', 's1']) {
    const program = new Program(['sensor', '--source', `rig:${rig}#${sensor}`, '--hub', hub.url, '--codec', 'lossless', '--verbose']);
    t.after(() => program.stop('SIGKILL'));
    await program.prints(/joined/);
  }
  return hub;
}

/** x, y, z of each point of a foxglove.PointCloud. */
function positionsOf({ data, pointStride }) {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const positions = new Float32Array((3 * data.length) / pointStride);
  for (let i = 0; i < positions.length; ++i) positions[i] = view.getFloat32(pointStride * Math.floor(i / 3) + 4 * (i % 3), true);
  return positions;
}

const python = '/usr/bin/python3';
const modules = resolve(dirname(binary), '../python');
const noPython = existsSync(join(modules, 'roomcast')) ? false : `the Python module is not built in ${modules}`;

/** Writes the clouds of the next sets of a room as Python has them: for each its length, then x, y, z. */
const savesClouds = `
import struct, sys, roomcast
with roomcast.watch(sys.argv[1]) as room, open(sys.argv[2], "wb") as out:
    sets = 0
    for frames in room:
        if len(frames) < 2: continue
        points = frames.points().xyz
        out.write(struct.pack("<i", len(points)) + points.astype("<f4").tobytes())
        sets += 1
        if sets == int(sys.argv[3]): break
`;

async function cloudsInPython(t, url, count) {
  const file = join(scratchFolder(t), 'clouds');
  const child = spawn(python, ['-c', savesClouds, url, file, String(count)], {
    env: { ...process.env, PYTHONPATH: modules, PYTHONDONTWRITEBYTECODE: '1' },
    stdio: ['ignore', 'ignore', 'inherit'],
    timeout: 25_000,
  });
  const [code] = await once(child, 'close');
  assert.equal(code, 0);
  const bytes = readFileSync(file);
  const clouds = [];
  for (let at = 0; at < bytes.length; ) {
    const end = at + 4 + 12 * bytes.readInt32LE(at);
    clouds.push(new Float32Array(Uint8Array.from(bytes.subarray(at + 4, end)).buffer));
    at = end;
  }
  return clouds;
}

function largestDifference(a, b) {
  if (a.length !== b.length) return Infinity;
  let largest = 0;
  for (let i = 0; i < a.length; ++i) largest = Math.max(largest, Math.abs(a[i] - b[i]));
  return largest;
}

test('points_are_those_that_python_receives_to_a_tenth_of_a_millimetre', { skip: noPython }, async (t) => {
  const hub = await startSmallRoom(t);
  const { url } = await startFoxglove(t, hub, '--up', 'y');
  const client = await FoxgloveClient.connect(t, url);
  await client.until('all topics', () => client.topics().length === 8);
  client.subscribe('/points');
  // The recording repeats after 20 instants, so in 3 s both see the same ones.
  const clouds = await cloudsInPython(t, hub.url, 45);
  await client.until('clouds', () => client.of('/points').length >= 25);
  const whole = client.of('/points').map(({ content }) => positionsOf(content)).filter(({ length }) => clouds.some((cloud) => cloud.length === length));
  let same = 0;
  for (const positions of whole) {
    const differences = clouds.map((cloud) => largestDifference(cloud, positions)).sort((a, b) => a - b);
    if (differences[0] < 1e-4) ++same;
    else assert.ok(differences[0] > 5e-3, `${differences[0]} m: nearly the same instant, which the recording has not`);
  }
  assert.ok(same >= 15, `${same} of ${whole.length} clouds are also in Python's ${clouds.length}`);
});

test('depth_calibrations_and_poses_give_the_points_with_z_up', async (t) => {
  const hub = await startSmallRoom(t);
  const { url } = await startFoxglove(t, hub);
  const client = await FoxgloveClient.connect(t, url);
  await client.until('all topics', () => client.topics().length === 8);
  assert.deepEqual(client.topics(), ['/points', '/s0/camera', '/s0/color', '/s0/depth', '/s1/camera', '/s1/color', '/s1/depth', '/tf']);
  client.subscribe('/s0/depth', '/s0/camera', '/tf');
  await client.until('a pose', () => client.of('/tf').length > 3 && client.of('/s0/depth').length > 3 && client.of('/s0/camera').length > 0);
  const { content: depth, time } = client.of('/s0/depth').at(-1);
  assert.deepEqual([depth.encoding, depth.width, depth.height, depth.step, depth.frameId], ['16UC1', 64, 48, 128, 's0']);
  const pixels = new Uint16Array(Uint8Array.from(depth.data).buffer);
  const first = pixels[0];
  assert.ok(first >= 1500 && first < 1700 && first % 10 === 0, `${first}`);
  for (let i = 0; i < pixels.length; ++i) assert.equal(pixels[i], first + (i % 64) + Math.floor(i / 64));
  const { content: camera } = client.of('/s0/camera')[0];
  assert.deepEqual(camera.K, [60, 0, 31.5, 0, 60, 23.5, 0, 0, 1]);
  // s0 is 2 m in front of the middle of the room and 1.5 m high; with z up its height is z.
  const pose = client.of('/tf').at(-1).content.transforms.find(({ childFrameId }) => childFrameId === 's0');
  assert.equal(pose.parentFrameId, 'world');
  const { x, y, z } = pose.translation;
  for (const [value, expected] of [[x, 0], [y, -2], [z, 1.5]]) assert.ok(Math.abs(value - expected) < 1e-9, `${x}, ${y}, ${z}`);
  // Capture times are those of day.
  assert.ok(Math.abs(Number(time) / 1e6 - Date.now()) < 10_000, `${time}`);
  assert.equal(BigInt(depth.timestamp.seconds) * 1_000_000_000n + BigInt(depth.timestamp.nanos), time);
});

test('colour_is_jpeg_and_topics_end_with_their_subscription', async (t) => {
  const hub = await startHub(t);
  await startSensor(t, hub);
  const { url } = await startFoxglove(t, hub);
  const client = await FoxgloveClient.connect(t, url);
  await client.until('a sensor', () => client.topics().some((topic) => topic.endsWith('/color')));
  const topic = client.topics().find((name) => name.endsWith('/color'));
  client.subscribe(topic);
  await client.until('pictures', () => client.of(topic).length > 2);
  const { format, data } = client.of(topic)[0].content;
  assert.equal(format, 'jpeg');
  assert.deepEqual([...data.subarray(0, 2), ...data.subarray(-2)], [0xff, 0xd8, 0xff, 0xd9]);
  const [id] = [...client.channels.values()].filter((channel) => channel.topic === topic).map((channel) => channel.id + 100);
  client.say({ op: 'unsubscribe', subscriptionIds: [id] });
  client.say({ op: 'unsubscribe', subscriptionIds: [id] }); // the answer tells that the first was read
  await client.until('the answer', () => client.statuses.length === 1);
  const before = client.messages.length;
  await new Promise((resolved) => setTimeout(resolved, 500));
  assert.equal(client.messages.length, before);
});

test('sensors_that_join_later_are_advertised', async (t) => {
  const hub = await startHub(t);
  const { url } = await startFoxglove(t, hub);
  const client = await FoxgloveClient.connect(t, url);
  await client.until('the room', () => client.topics().join() === '/points,/tf');
  assert.match(client.info.name, /roomcast/);
  await startSensor(t, hub, '--name', 'late');
  await client.until('the sensor', () => client.topics().includes('/late/depth'));
});

test('foreign_pages_cannot_connect', async (t) => {
  const hub = await startHub(t);
  const { url } = await startFoxglove(t, hub, '--origin', 'https://lab.example');
  await assert.rejects(FoxgloveClient.connect(t, url, { origin: 'https://evil.example' }), /403/);
  for (const origin of ['https://lab.example', 'https://app.foxglove.dev', 'http://localhost:8080']) {
    await FoxgloveClient.connect(t, url, { origin });
  }
});

test('a_room_that_does_not_let_viewers_export_is_not_served', async (t) => {
  const config = join(scratchFolder(t), 'roomcast.toml');
  writeFileSync(config, '[[room]]\nname = "lab"\nexport = "admin"\n');
  const hub = await startHub(t, '--config', config);
  assertFailed(await run('foxglove', '--hub', hub.url, '--port', '0'), 1, /does not let viewers export/);
});

test('other_addresses_need_a_word', async (t) => {
  const hub = await startHub(t);
  const open = ['foxglove', '--hub', hub.url, '--port', '0', '--address', '0.0.0.0'];
  assertFailed(await run(...open), 2, /everybody who reaches 0\.0\.0\.0 could watch.*--insecure/);
  assertFailed(await run('foxglove', '--hub', hub.url, '--address', 'lab.example'), 2, /numeric address/);
  const program = new Program([...open, '--insecure', '--json']);
  t.after(() => program.stop('SIGKILL'));
  const [, port] = await program.prints(/"ws:\/\/0\.0\.0\.0:(\d+)"/);
  await FoxgloveClient.connect(t, `ws://127.0.0.1:${port}`);
  assertFailed(await run('foxglove', '--hub', hub.url, '--port', port), 1, /cannot listen on 127\.0\.0\.1/);
  assert.equal(await program.stop(), 0);
});

test('a_hub_that_is_not_there_is_a_sentence', async () => {
  assertFailed(await run('foxglove', '--hub', 'ws://127.0.0.1:1', '--port', '0'), 1, /127\.0\.0\.1/);
});
