// SPDX-License-Identifier: Apache-2.0
// Measures the cost of forwarding a room from hub to hub, relative to the cost of sending it to a viewer at the same
// hub. Both are differences of larger loads, and for one room hardly exceed the noise of these loads. Therefore there
// are ROOMCAST_COST_ROOMS equal rooms at once, and the share of one room is reported. All loads are measured in turn,
// ROOMCAST_COST_ROUNDS times, and the median of the differences counts. Times are the scheduler's own (schedstat,
// nanoseconds), over all threads of a hub. Each viewer is a process of its own, because waking a sleeping process is
// part of the cost of sending to it.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as delay } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';

import { SendingSensor } from './room_client.mjs';

export const costRounds = Number(process.env.ROOMCAST_COST_ROUNDS ?? 1);
export const costRooms = Number(process.env.ROOMCAST_COST_ROOMS ?? (costRounds > 1 ? 8 : 1));
/** Time limit of all rounds. */
export const costTimeout_ms = costRounds * (40_000 + 6000 * costRooms);
/**
 * Frame sizes of a quiet room, of a room with people exercising, and of lossless depth (docs/benchmarks.md has the
 * sizes), to separate the cost per message from the cost per byte. Several rounds measure each.
 */
export const costFrames_bytes = costRounds > 1 ? [1000, 8000, 40_000] : [8000];
const costOver_s = costRounds > 1 ? 5 : 2;
const fetchedUnwatched_ms = 4000; // 3 s, and the time to report it
const more = costRooms > 1 ? 1 : 10; // viewers per room
const rooms = Array.from({ length: costRooms }, (_, n) => `r${n}`);

/** Options of a hub with these rooms. */
export function costRoomsOption(folder) {
  const file = join(folder, 'rooms.toml');
  writeFileSync(file, rooms.map((room) => `[[room]]\nname = "${room}"\n`).join(''));
  return ['--config', file];
}

/** Starts four sensors in each room. */
export function startCostSensors(t, hub, payloadBytes) {
  const names = ['s0', 's1', 's2', 's3'];
  return Promise.all(
    rooms.flatMap((room) => names.map((name) => SendingSensor.start(t, hub.url, { room, name, fps: 30, payloadBytes }))));
}

/** Processor time of each thread of a process so far. */
function taken_ms(child) {
  const threads = `/proc/${child.pid}/task`;
  return new Map(readdirSync(threads).map(
    (thread) => [thread, Number(readFileSync(`${threads}/${thread}/schedstat`, 'utf8').split(' ')[0]) / 1e6]));
}

/** Processor time used by each process per second, in milliseconds; threads that end meanwhile do not count. */
async function loads_ms(children) {
  const before = children.map(taken_ms);
  await delay(1000 * costOver_s);
  return children.map((child, i) => sum([...taken_ms(child)].map(([thread, ms]) => ms - (before[i].get(thread) ?? 0))) / costOver_s);
}

const sum = (values) => values.reduce((all, value) => all + value, 0);
const minus = (a, b) => a.map((value, i) => value - b[i]);

/** The median and the interquartile range. */
function spread(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (share) => sorted[Math.floor(share * (sorted.length - 1) + 0.5)];
  return { median: sorted[Math.floor(sorted.length / 2)], text: `${sorted[Math.floor(sorted.length / 2)].toFixed(2)} [${at(0.25).toFixed(2)}, ${at(0.75).toFixed(2)}]` };
}

/** A process that views a room at `hub` until its input is closed. */
async function startViewer(t, hub, room) {
  const program = fileURLToPath(new URL('lone_viewer.mjs', import.meta.url));
  const child = spawn(process.execPath, [program, hub.url, room], { stdio: ['pipe', 'pipe', 'inherit'] });
  t.after(() => child.kill('SIGKILL'));
  await once(child.stdout, 'data');
  return {
    /** Share of the sets sent since the last call. */
    shareSeen: async () => (child.stdin.write('?\n'), Number(await once(child.stdout, 'data'))),
    stop: () => (child.stdin.end(), once(child, 'exit')),
  };
}

/** Loads while these viewers receive nearly all sets. Reports if they do not, because lost sets cost nothing. */
async function loadsWith_ms(t, viewers, children) {
  const seen = () => Promise.all(viewers.map((viewer) => viewer.shareSeen()));
  await delay(1000); // until the start-up load is over
  await seen();
  const loads = await loads_ms(children);
  const shares = await seen();
  const least = Math.min(...shares);
  if (least < 0.95) t.diagnostic(`a viewer was sent ${(100 * least).toFixed(0)} % of all sets only: the machine is too busy`);
  return loads;
}

/**
 * One round of loads per process and room: no viewer; one at the origin; more there; none; one at the edge. The edge's
 * cost for sending to its viewer equals the origin's, so it does not count as forwarding cost.
 */
async function costRound(t, { origin, edge, children }) {
  const start = (hub, count) => Promise.all(
    rooms.flatMap((room) => Array.from({ length: count }, () => startViewer(t, hub, room))));
  const stop = (viewers) => Promise.all(viewers.map((viewer) => viewer.stop()));
  const nobodyWatches_ms = async () => (await delay(fetchedUnwatched_ms), loads_ms(children));
  const ofRoom = (load_ms) => load_ms / costRooms;

  const nobody = await nobodyWatches_ms();
  const local = await start(origin, 1);
  const one = await loadsWith_ms(t, local, children);
  local.push(...await start(origin, more));
  const all = await loadsWith_ms(t, local, children);
  await stop(local);
  const nobodyAgain = await nobodyWatches_ms();
  const remote = await start(edge, 1);
  const there = minus(await loadsWith_ms(t, remote, children), nobodyAgain);
  await stop(remote);
  return {
    sensors: ofRoom(nobody[0]),
    first: ofRoom(sum(minus(one, nobody).slice(0, 2))),
    another: ofRoom(sum(minus(all, one).slice(0, 2))) / more,
    sends: ofRoom(there[0]),
    gets: ofRoom(there[1]),
    broker: ofRoom(sum(there.slice(2))),
  };
}

/** Sensors send to rooms of `origin`; `edge` receives them from `origin`, through `brokers` if there are any. */
export async function tellCost(t, { origin, edge, brokers = [] }) {
  const children = [origin.program.child, edge.program.child, ...brokers.map(({ child }) => child)];
  const rounds = [];
  for (let round = 0; round < costRounds; ++round) rounds.push(await costRound(t, { origin, edge, children }));
  const of = (what) => spread(rounds.map(typeof what === 'string' ? (round) => round[what] : what));
  const against = (name, what) => {
    const local = of(what);
    const hubToHub = of((round) => round.sends + round.gets - round[what]);
    t.diagnostic(`${name} takes ${local.text}; hub to hub ${hubToHub.text}, ${(hubToHub.median / local.median).toFixed(1)} times as much`);
  };
  t.diagnostic(
    `milliseconds of processor a second for each of ${costRooms} rooms, median of ${costRounds} [half of them]: 4 sensors ${of('sensors').text}; with somebody at the next ` +
      `hub who sends takes ${of('sends').text} more, who gets and shows ${of('gets').text}` + (brokers.length > 0 ? `, NATS ${of('broker').text}` : ''));
  against('one local viewer, where there was none,', 'first');
  against(more === 1 ? 'another one' : `one more of ${more} that come to another`, 'another');
}
