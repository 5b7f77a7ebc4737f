// SPDX-License-Identifier: Apache-2.0
// Compares two roomcast programs as hubs that share rooms over NATS: ROOMCAST_BIN and ROOMCAST_OTHER_BIN run side by
// side, with equal loads, so that whatever else the machine does affects both. Each hub has four rooms with four
// sensors, and a viewer in each room of the other hub. Reports the processor time of both hubs and of nats-server in
// windows of four seconds, the ratio in each window, and threads and memory. More windows, and one size of frames:
// ROOMCAST_OTHER_BIN=... ROOMCAST_WINDOWS=8 ROOMCAST_FRAME_BYTES=8000 node --test tests/network/compare_hubs.mjs
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';

import { binary, scratchFolder } from '../cli/program.mjs';
import { env } from '../state_folder.mjs';
import { makeCertificate } from './certificate.mjs';
import { natsIsMissing, startNode } from './nats.mjs';
import { SendingSensor } from './room_client.mjs';

const other = process.env.ROOMCAST_OTHER_BIN;
const windows = Number(process.env.ROOMCAST_WINDOWS ?? 2);
const frameBytes = Number(process.env.ROOMCAST_FRAME_BYTES ?? 8000);
const roomCount = Number(process.env.ROOMCAST_COST_ROOMS ?? 4);
const window_ms = 4000;
const sensors = ['s0', 's1', 's2', 's3'];
const viewerProgram = fileURLToPath(new URL('lone_viewer.mjs', import.meta.url));

const roomsOf = (hub) => Array.from({ length: roomCount }, (_, n) => `of_${hub}_${n}`);

async function startHub(t, program, options) {
  const child = spawn(program, ['hub', '--listen', '127.0.0.1:0', '--threads', '1', '--no-align', '--data', scratchFolder(t), ...options], { env });
  t.after(() => child.kill('SIGKILL'));
  let said = '';
  for (const stream of [child.stdout, child.stderr]) stream.setEncoding('utf8').on('data', (text) => (said += text));
  for (let port; ; await delay(20)) {
    port = /open https?:\/\/127\.0\.0\.1:(\d+)\//.exec(said)?.[1];
    if (port) return { child, url: `ws://127.0.0.1:${port}` };
  }
}

async function startViewer(t, hub, room) {
  const child = spawn(process.execPath, [viewerProgram, hub.url, room], { stdio: ['pipe', 'pipe', 'inherit'] });
  t.after(() => child.kill('SIGKILL'));
  await once(child.stdout, 'data');
  return { shareSeen: async () => (child.stdin.write('?\n'), Number(await once(child.stdout, 'data'))) };
}

function taken_ms({ child }) {
  const threads = `/proc/${child.pid}/task`;
  return readdirSync(threads).reduce(
    (sum, thread) => sum + Number(readFileSync(`${threads}/${thread}/schedstat`, 'utf8').split(' ')[0]) / 1e6, 0);
}

async function loads_ms(processes) {
  const [before, began_ms] = [processes.map(taken_ms), performance.now()];
  await delay(window_ms);
  const over_s = (performance.now() - began_ms) / 1000;
  return processes.map((each, i) => (taken_ms(each) - before[i]) / over_s);
}

function spread(values, digits) {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1) + 0.5)].toFixed(digits);
  return `${at(0.5)} [${at(0)}, ${at(1)}]`;
}

const statusOf = ({ child }, what) => Number(new RegExp(`${what}:\\s+(\\d+)`).exec(readFileSync(`/proc/${child.pid}/status`, 'utf8'))[1]);

for (const encrypted of [false, true]) {
  test(`what_two_hubs_cost${encrypted ? '_encrypted' : ''}`, { skip: natsIsMissing || (other ? false : 'no ROOMCAST_OTHER_BIN'), timeout: 60_000 + 2 * windows * window_ms }, async (t) => {
    const folder = scratchFolder(t);
    const { file } = await makeCertificate(t, folder);
    const node = await startNode(t, encrypted ? { scheme: 'tls', more: `tls { cert_file: "${file}", key_file: "${file}" }` } : {});
    const config = join(folder, 'rooms.toml');
    writeFileSync(config, [...roomsOf(0), ...roomsOf(1)].map((room) => `[[room]]\nname = "${room}"\n`).join(''));
    const options = ['--config', config, '--nats', node.url, ...(encrypted ? ['--nats-ca', file] : [])];
    const hubs = [await startHub(t, binary, options), await startHub(t, other, options)];
    await delay(2000);
    const idle = await loads_ms(hubs);
    await Promise.all(hubs.flatMap((hub, h) => roomsOf(h).flatMap(
      (room) => sensors.map((name) => SendingSensor.start(t, hub.url, { room, name, fps: 30, payloadBytes: frameBytes })))));
    const viewers = await Promise.all(hubs.flatMap((hub, h) => roomsOf(1 - h).map((room) => startViewer(t, hub, room))));
    const seen = () => Promise.all(viewers.map((viewer) => viewer.shareSeen()));
    await delay(2000);
    await seen();
    const loads = [];
    while (loads.length < windows) loads.push(await loads_ms([...hubs, node]));
    const least = Math.min(...await seen());
    const of = (column) => spread(loads.map((load) => load[column]), 1);
    t.diagnostic(`frames of ${frameBytes} bytes, ms a second: ${of(0)}, the other ${of(1)}, NATS ${of(2)}; idle ${idle.map((ms) => ms.toFixed(1)).join(', the other ')}`);
    t.diagnostic(`the other takes ${spread(loads.map(([own, others]) => others / own), 2)} times as much; viewers got ${(100 * least).toFixed(0)} % of all sets at least`);
    t.diagnostic(`threads ${hubs.map((hub) => statusOf(hub, 'Threads'))}, most memory ${hubs.map((hub) => (statusOf(hub, 'VmHWM') / 1024).toFixed(0))} MB`);
  });
}
