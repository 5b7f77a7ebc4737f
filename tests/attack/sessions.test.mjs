// SPDX-License-Identifier: Apache-2.0
// Attacks a running hub with the sessions of sensors, viewers and aligners and with HTTP requests, all of them altered; and
// clients with a hub that lies. The hub goes on to serve those who behave, and keeps its memory and its descriptors.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { existsSync, mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { connect } from 'node:net';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, run, scratchFolder, startHub } from '../cli/program.mjs';
import { makeToken } from '../network/admin.mjs';
import { readMessage, writeClockPing, writeJoin, writePlacement, writeViewerPose } from '../network/messages.mjs';
import { WebSocket, WebSocketServer } from '../network/npm.mjs';
import { RoomClient, SendingSensor } from '../network/room_client.mjs';
import { longestPause_ms, startSensor } from '../network/rooms.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { faultsOf, runAttacked } from './attacked_program.mjs';
import { attackInTurn, timeout } from './attacker.mjs';
import { damaged } from './damage.mjs';
import { Proxy } from './overheard.mjs';

const subprotocol = 'roomcast.v1';
const handshake =
  'GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n' +
  `Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Protocol: ${subprotocol}\r\n\r\n`;
const atATime = 16;
const mostMessages = 120;
const answersWithin_ms = 2_000;
const staysOpen_ms = 150;
const fps = 20;
const longestStop_ms = 3_000;
const mostGrowth_mb = 100;
const mostDescriptorGrowth = 10;
const settlesWithin_ms = 15_000;
const leastWelcomedShare = 0.2; // of the sessions: the others were turned away at the door
const patience_ms = 2_000;
const lyingHubs = 4; // each with one client at a time

/** A hub with two rooms: the attacked one, and another, of which the attackers have an admin's token. */
async function startAttackedHub(t) {
  const data = scratchFolder(t);
  const config = join(data, 'roomcast.toml');
  writeFileSync(config, '[[room]]\nname = "room"\n[[room]]\nname = "other"\n');
  const admin = (await makeToken(data, '--role', 'admin', '--room', 'other', '--ttl', '7d')).token;
  const args = ['hub', '--listen', '127.0.0.1:0', '--data', data, '--config', config, '--log', 'json', '--verbose'];
  const program = new Program(args, { limitMs: timeout.timeout });
  t.after(() => program.stop('SIGKILL'));
  const port = await program.port();
  return { program, port, url: `ws://127.0.0.1:${port}`, admin };
}

/** Each attacker comes from an address of its own: the hub bans addresses, which must not meet the others. */
function addressOf(random) {
  return `127.1.${random.below(256)}.${1 + random.below(254)}`;
}

/** What is said in rooms of real programs: [{fromClient, fromHub}], and sessions that no program has by itself. */
async function overhear(t) {
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder);
  const hub = await startHub(t);
  const proxy = await Proxy.start(t, hub.url);
  const sensors = [await startSensor(t, proxy.url, rig, 0), await startSensor(t, proxy.url, rig, 1)];
  const picture = ['--headless', '--size', '64,48', '--png', join(folder, 'a.png'), '--seconds', '2'];
  await Promise.all([
    run('view', '--hub', proxy.url, ...picture),
    run('record', join(folder, 'a.mcap'), '--hub', proxy.url, '--seconds', '3'),
  ]);
  await Promise.all([...sensors, hub.program].map((program) => program.stop('SIGKILL')));
  assert.ok(proxy.sessions.length >= 4, `${proxy.sessions.length} sessions were overheard`);
  return proxy.sessions.filter(({ fromClient }) => fromClient.length > 0);
}

function goldenMessages() {
  const folder = new URL('../golden/', import.meta.url);
  return readdirSync(folder).filter((name) => /^wire_.*\.bin$/.test(name)).map((name) => readFileSync(new URL(name, folder)));
}

/** Sessions of clients: lists of messages, the first of which is a join. */
function clientSessions(overheard, admin) {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const aligner = [writeJoin({ room: 'other', name: 'aligner', aligner: true, token: admin }), writePlacement({ sensor: 1, worldFromDepth: identity })];
  const viewer = [writeJoin({ room: 'room', name: 'viewer' }), writeViewerPose([1, 1.6, 2]), writeClockPing(1n), writeViewerPose([0, 1.6, 2])];
  const sensor = writeJoin({ room: 'room', name: 'sensor', sensor: { fps: 30 } });
  const inRoom = overheard.map(({ fromClient }) => fromClient);
  return [...inRoom, aligner, viewer, [sensor, ...goldenMessages()], [viewer[0], ...goldenMessages()]];
}

const frameType = 2;
const isFrame = (message) => message.length >= 48 && message.readUInt16LE(0) === 0x4352 && message[3] === 1;

/** A frame as if it had been captured just now by this sensor. */
function renewed(message, sensorId, roomNow_ns) {
  const frame = Buffer.from(message);
  frame.writeUInt16LE(sensorId & 0xffff, 8);
  frame.writeBigInt64LE(roomNow_ns, 24);
  return frame;
}

/** One altered session: some of its messages are damaged, doubled, left out, or said at the wrong time. */
async function attackAsClient(random, { url, sessions, roomNow_ns, tally }) {
  const session = random.pick(sessions);
  const socket = new WebSocket(`${url}/ws`, subprotocol, { perMessageDeflate: false, localAddress: addressOf(random) });
  const closed = new Promise((resolve) => socket.on('close', resolve));
  socket.on('error', () => {});
  let sensorId = random.below(4);
  let isWelcome = false;
  socket.on('message', (bytes) => {
    const welcome = welcomeOf(bytes);
    isWelcome ||= welcome !== undefined;
    sensorId = welcome?.sensorId ?? sensorId;
  });
  await Promise.race([once(socket, 'open'), closed, delay(answersWithin_ms)]);
  const from = random.isTrue(0.8) ? 0 : random.below(session.length);
  for (const [i, message] of session.slice(from, from + 1 + random.below(mostMessages)).entries()) {
    if (socket.readyState !== WebSocket.OPEN) break;
    if (i > 0 && random.isTrue(0.05)) continue;
    sendAltered(socket, isFrame(message) ? renewed(message, sensorId, roomNow_ns()) : message, random, i === 0);
    if (i === 0 || random.isTrue(0.1)) await delay(random.below(30));
  }
  await Promise.race([closed, delay(staysOpen_ms)]);
  random.isTrue(0.5) ? socket.terminate() : socket.close();
  await Promise.race([closed, delay(answersWithin_ms)]);
  socket.terminate();
  ++tally.sessions;
  tally.welcomed += isWelcome;
  return [];
}

function welcomeOf(bytes) {
  try {
    const { control } = readMessage(bytes);
    return control?.case === 'welcome' ? control : undefined;
  } catch {
    return undefined;
  }
}

function sendAltered(socket, message, random, isJoin) {
  const bytes = random.isTrue(isJoin ? 0.2 : 0.4) ? damaged(message, random) : message;
  const binary = !random.isTrue(0.02);
  const fin = !random.isTrue(0.03);
  socket.send(bytes, { binary, fin });
  if (random.isTrue(0.03)) socket.send(bytes, { binary, fin: true });
  if (random.isTrue(0.02)) socket.ping(random.bytes(random.below(126)));
}

/** Requests that each do something, in the order of the specification. */
function httpRequests(admin) {
  const headers = `Host: 127.0.0.1\r\nAuthorization: Bearer ${admin}\r\n`;
  const body = (method, path, json) => `${method} ${path} HTTP/1.1\r\n${headers}Content-Type: application/json\r\nContent-Length: ${json.length}\r\n\r\n${json}`;
  const plain = (method, path) => `${method} ${path} HTTP/1.1\r\n${headers}\r\n`;
  const api = '/api/v1';
  return [
    ...['/', '/index.html', '/healthz', '/metrics', '/assets/', `${api}/status`, `${api}/hubs`, `${api}/rooms`].map((path) => plain('GET', path)),
    ...['', '/sensors', '/viewers', '/recording'].map((path) => plain('GET', `${api}/rooms/other${path}`)),
    ...['/sensors/s0', '/viewers/1', '/recording', ''].map((path) => plain('DELETE', `${api}/rooms/other${path}`)),
    plain('POST', `${api}/rooms/other/recording`),
    body('POST', `${api}/rooms`, '{"name":"third","title":"Third"}'),
    body('PATCH', `${api}/rooms/other`, '{"title":"A room","max_viewers":3,"view":"token"}'),
    body('POST', `${api}/tokens`, '{"room":"other","role":"viewer","ttl_s":60,"name":"Ada"}'),
    plain('GET', `${api}/tokens?room=other`),
    plain('DELETE', `${api}/tokens/abc`),
    handshake,
    `POST ${api}/tokens HTTP/1.1\r\n${headers}Transfer-Encoding: chunked\r\n\r\n4\r\n{"ro\r\n0\r\n\r\n`,
  ].map((text) => Buffer.from(text, 'latin1'));
}

/** Bytes of one or several altered requests; what is answered must be HTTP, and no fault of the hub's. */
async function attackByHttp(random, { port, requests, tally }) {
  const sent = Array.from({ length: 1 + random.below(3) }, () => {
    const bytes = random.pick(requests);
    return random.isTrue(0.8) ? damaged(bytes, random) : bytes;
  });
  const stream = connect({ port, host: '127.0.0.1', localAddress: addressOf(random) });
  const closed = new Promise((resolve) => stream.on('close', resolve));
  let answer = '';
  stream.on('error', () => {}).on('data', (bytes) => (answer += bytes.toString('latin1')));
  stream.end(Buffer.concat(sent));
  await Promise.race([closed, delay(staysOpen_ms + random.below(answersWithin_ms))]);
  stream.destroy();
  const status = /^HTTP\/1\.1 (\d{3}) /.exec(answer)?.[1];
  if (status) tally.answered.set(status, (tally.answered.get(status) ?? 0) + 1);
  if (answer === '' || (status && !status.startsWith('5'))) return [];
  return [`the hub answered ${JSON.stringify(answer.slice(0, 200))} to ${JSON.stringify(Buffer.concat(sent).toString('latin1').slice(0, 300))}`];
}

/** A handshake and frames whose bytes are damaged, so that the framing itself is wrong. */
async function attackAsSocket(random, { port, sessions }) {
  const stream = connect({ port, host: '127.0.0.1', localAddress: addressOf(random) });
  const closed = new Promise((resolve) => stream.on('close', resolve));
  stream.on('error', () => {}).resume();
  stream.write(handshake);
  const messages = random.pick(sessions).slice(0, 1 + random.below(5));
  const frames = Buffer.concat(messages.map((message) => maskedFrame(message, random)));
  stream.write(random.isTrue(0.9) ? damaged(frames, random) : frames);
  await Promise.race([closed, delay(staysOpen_ms)]);
  stream.destroy();
  return [];
}

/** RFC 6455, section 5.2. */
function maskedFrame(payload, random) {
  const mask = random.bytes(4);
  const header = Buffer.alloc(payload.length < 126 ? 2 : payload.length < 65_536 ? 4 : 10);
  header[0] = 0x80 | frameType;
  header[1] = 0x80 | (header.length === 2 ? payload.length : header.length === 4 ? 126 : 127);
  if (header.length === 4) header.writeUInt16BE(payload.length, 2);
  if (header.length === 10) header.writeBigUInt64BE(BigInt(payload.length), 2);
  return Buffer.concat([header, mask, payload.map((byte, i) => byte ^ mask[i % 4])]);
}

function usageOf({ child }) {
  const folder = `/proc/${child.pid}`;
  const rss_mb = Number(/VmRSS:\s+(\d+) kB/.exec(readFileSync(`${folder}/status`, 'utf8'))[1]) / 1000;
  return { rss_mb, descriptors: readdirSync(`${folder}/fd`).length };
}

async function settled(program, before) {
  const deadline = Date.now() + settlesWithin_ms;
  for (;;) {
    const now = usageOf(program);
    if (now.descriptors <= before.descriptors + mostDescriptorGrowth || Date.now() > deadline) return now;
    await delay(100);
  }
}

function assertLogIsJson(log) {
  for (const line of log.trimEnd().split('\n')) {
    if (/^roomcast hub: /.test(line)) continue;
    assert.doesNotThrow(() => JSON.parse(line), `a line of the log: ${line}`);
  }
}

function statusOf(port) {
  return new Promise((resolve, reject) => {
    request({ port, host: '127.0.0.1', path: '/healthz' }, (answer) => (answer.resume(), resolve(answer.statusCode))).on('error', reject).end();
  });
}

test('no_session_and_no_request_makes_a_hub_fall_over', timeout, async (t) => {
  const overheard = await overhear(t);
  const { program, port, url, admin } = await startAttackedHub(t);
  const honest = await SendingSensor.start(t, url, { room: 'room', name: 'honest', fps });
  const witness = await RoomClient.join(t, url, { room: 'room', name: 'witness' });
  await witness.until('the honest sensor', () => witness.sets.length > 5);
  const before = usageOf(program);
  const sessions = clientSessions(overheard, admin);
  const tally = { sessions: 0, welcomed: 0, answered: new Map() };
  const context = { tally, url, port, sessions, requests: httpRequests(admin), roomNow_ns: () => process.hrtime.bigint() + honest.roomMinusHostNs };
  const attacks = [attackAsClient, attackAsClient, attackByHttp, attackAsSocket];
  await attackInTurn(t, (random, number) => attacks[number % attacks.length](random, context), { atATime });

  const answers = [...tally.answered].sort().map(([status, count]) => `${status}: ${count}`);
  t.diagnostic(`${tally.welcomed} of ${tally.sessions} sessions were welcome; HTTP ${answers.join(', ')}`);
  assert.ok(tally.welcomed >= leastWelcomedShare * tally.sessions, 'the hub let them in');
  const after = await settled(program, before);
  t.diagnostic(`memory ${before.rss_mb.toFixed(1)} -> ${after.rss_mb.toFixed(1)} MB, descriptors ${before.descriptors} -> ${after.descriptors}`);
  assert.equal(program.child.exitCode, null, `the hub is up: ${program.stderr.slice(-500)}`);
  assert.equal(witness.end, undefined, 'the witness was not disconnected');
  assert.equal(honest.client.end, undefined, 'the honest sensor was not disconnected');
  t.diagnostic(`longest pause ${longestPause_ms(witness).toFixed(0)} ms in ${witness.sets.length} sets`);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);
  assert.ok(after.rss_mb < before.rss_mb + mostGrowth_mb, 'the memory did not grow');
  assert.ok(after.descriptors <= before.descriptors + mostDescriptorGrowth, 'the descriptors are free again');
  const newcomer = await RoomClient.join(t, url, { room: 'room', name: 'newcomer' });
  await newcomer.until('frames', () => newcomer.sets.length > 5);
  assert.equal(await statusOf(port), 200);
  assert.equal(await program.stop('SIGTERM'), 0);
  assertLogIsJson(program.stderr);
});

/** A hub that says what a real one has said, altered. */
async function startLyingHub(t, sessions) {
  const server = new WebSocketServer({ port: 0, host: '127.0.0.1', handleProtocols: () => subprotocol });
  await once(server, 'listening');
  t.after(() => (server.clients.forEach((client) => client.terminate()), server.close()));
  const lying = { url: `ws://127.0.0.1:${server.address().port}`, random: null };
  server.on('connection', (socket) => {
    socket.on('error', () => {});
    socket.once('message', () => lie(socket, lying.random, sessions));
  });
  return lying;
}

async function lie(socket, random, sessions) {
  const session = random.pick(sessions);
  for (const [i, message] of session.entries()) {
    if (socket.readyState !== WebSocket.OPEN) return;
    const isDamaged = random.isTrue(i < 2 ? 0.1 : 0.3);
    socket.send(isDamaged ? damaged(message, random) : message, { binary: !random.isTrue(0.01), fin: !random.isTrue(0.01) });
    if (random.isTrue(0.2)) await delay(random.below(20));
  }
}

/** Programs that join a hub, [arguments]. */
function clients(url, rig, folder) {
  return [
    ['record', join(folder, 'a.mcap'), '--hub', url, '--seconds', '1.5'],
    ['view', '--hub', url, '--headless', '--size', '64,48', '--png', join(folder, 'a.png')],
    ['view', '--hub', url, '--headless', '--size', '64,48', '--png', join(folder, 'a.png'), '--seconds', '1', '--json'],
    ['sensor', '--source', `rig:${rig}#s0`, '--hub', url, '--once', '--verbose'],
    ['nudge', 's0', '--hub', url, '--move', '0.1', '0', '0'],
  ];
}

test('no_hub_that_lies_makes_its_clients_fall_over', timeout, async (t) => {
  const sessions = (await overhear(t)).map(({ fromHub }) => fromHub).filter((messages) => messages.length > 1);
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder, { fps: 4 });
  const free = await Promise.all(Array.from({ length: lyingHubs }, () => startLyingHub(t, sessions)));
  const attack = async (random) => {
    const hub = free.pop();
    hub.random = random;
    const cwd = mkdtempSync(join(folder, 'case_'));
    const args = random.pick(clients(hub.url, rig, cwd));
    const result = await runAttacked(args, { through: [], cwd, env: { ...process.env, XDG_STATE_HOME: cwd }, patience_ms });
    const faults = faultsOf(result);
    const file = join(cwd, 'a.mcap');
    if (existsSync(file)) {
      const info = await runAttacked(['info', file], { through: [], cwd, env: process.env, patience_ms: 20_000 });
      if (info.code !== 0) faults.push(`${file} is refused by info: ${info.stderr}`);
    }
    free.push(hub);
    return faults;
  };
  await attackInTurn(t, attack, { atATime: lyingHubs });
});
