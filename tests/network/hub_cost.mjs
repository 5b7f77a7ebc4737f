// SPDX-License-Identifier: Apache-2.0
// What it costs to bring a room from hub to hub, against what it costs to bring it to one more viewer at the same hub.
import { readFileSync, readdirSync } from 'node:fs';
import { setTimeout as delay } from 'node:timers/promises';

import { RoomClient } from './room_client.mjs';
import { assertMissedNothing } from './rooms.mjs';

export const costRounds = Number(process.env.ROOMCAST_COST_ROUNDS ?? 1);
const costOver_s = costRounds > 1 ? 5 : 2;
const fetchedUnwatched_ms = 4000; // 3 s, and what it takes to say so

/** Processor time of a process so far. */
function taken_ms(child) {
  const threads = `/proc/${child.pid}/task`;
  return readdirSync(threads).reduce(
    (sum, thread) => sum + Number(readFileSync(`${threads}/${thread}/schedstat`, 'utf8').split(' ')[0]) / 1e6, 0);
}

/** Processor time that each of these takes in a second, in milliseconds. */
async function loads_ms(children) {
  const before = children.map(taken_ms);
  await delay(1000 * costOver_s);
  return children.map((child, i) => (taken_ms(child) - before[i]) / costOver_s);
}

const sum = (values) => values.reduce((all, value) => all + value, 0);
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** What these processes take more, each, with a viewer at `hub`, who misses nothing. */
async function extras_ms(t, hub, children, before) {
  const viewer = await RoomClient.join(t, hub.url);
  await viewer.moreSets(45);
  const with_viewer = await loads_ms(children);
  assertMissedNothing(viewer, [0, 1, 2, 3].map((n) => viewer.sensor(`s${n}`).id));
  viewer.socket.terminate();
  await viewer.closed;
  return with_viewer.map((load, i) => load - before[i]);
}

/** Sensors s0 to s3 send to `origin`; `edge` gets their room from it, by way of `brokers` if there are any. */
export async function tellCost(t, { origin, edge, brokers = [] }) {
  const children = [origin.program.child, edge.program.child, ...brokers.map(({ child }) => child)];
  const rounds = [];
  for (let round = 0; round < costRounds; ++round) {
    await delay(fetchedUnwatched_ms);
    const alone = await loads_ms(children);
    const local = await extras_ms(t, origin, children, alone);
    await delay(fetchedUnwatched_ms);
    const remote = await extras_ms(t, edge, children, await loads_ms(children));
    rounds.push({ alone: sum(alone.slice(0, 2)), local: sum(local.slice(0, 2)), sends: remote[0], gets: remote[1], broker: sum(remote.slice(2)) });
  }
  const of = (what) => median(rounds.map((round) => round[what]));
  const [alone, local, sends, gets, broker] = ['alone', 'local', 'sends', 'gets', 'broker'].map(of);
  const hubToHub = median(rounds.map((r) => r.sends + r.gets - r.local)); // the edge serves its viewer as the origin would
  t.diagnostic(
    `milliseconds of processor a second: 4 sensors ${alone.toFixed(1)}, one local viewer ${local.toFixed(1)}, hub to hub ` +
      `${hubToHub.toFixed(1)} (${(hubToHub / local).toFixed(1)} times as much; who sends ${sends.toFixed(1)}, who gets and shows ` +
      `${gets.toFixed(1)})` + (brokers.length > 0 ? `, the broker ${broker.toFixed(1)}` : ''));
}
