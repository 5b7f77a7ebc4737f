// SPDX-License-Identifier: Apache-2.0
// Starts a NATS cluster on loopback: real servers on free ports, with the settings recommended in docs/scale.md.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as delay } from 'node:timers/promises';

import { scratchFolder } from '../cli/program.mjs';

const env = { ...process.env, PATH: `${process.env.PATH}:/usr/sbin` }; // Debian's folder for it
const startWithin_ms = 10_000;

/** False, or the reason for skipping a test that needs it. */
export const natsIsMissing = spawnSync('nats-server', ['--version'], { env }).error
  ? 'nats-server is not installed (scripts/setup test)'
  : false;

/** Waits until a server has printed matches of all patterns; resolves to the captures of each. */
async function says(node, ...patterns) {
  const deadline = Date.now() + startWithin_ms;
  for (;;) {
    const matches = patterns.map((pattern) => pattern.exec(node.log));
    if (matches.every((match) => match)) return matches.map(([, caught]) => caught);
    if (node.child.exitCode !== null || Date.now() > deadline) throw new Error(`nats-server: ${node.log}`);
    await delay(20);
  }
}

/** Starts one server on free ports; it is stopped when the test ends. `more` is added to its configuration. */
export async function startNode(t, { routes, more = '', scheme = 'nats' } = {}) {
  const file = join(scratchFolder(t), 'nats.conf');
  const cluster = routes
    ? `cluster { name: roomcast, listen: "127.0.0.1:-1", no_advertise: true, routes: [${routes.map((route) => `"${route}"`).join(', ')}] }`
    : '';
  writeFileSync(
    file,
    `listen: "127.0.0.1:-1"\nhttp: "127.0.0.1:-1"\nping_interval: "1s"\nping_max: 2\nmax_payload: 2MB\nmax_pending: 16MB\n${cluster}\n${more}\n`,
  );
  const child = spawn('nats-server', ['-c', file], { env, stdio: ['ignore', 'ignore', 'pipe'] });
  const node = { child, log: '' };
  child.stderr.setEncoding('utf8').on('data', (text) => (node.log += text));
  const ended = once(child, 'exit');
  t.after(() => (child.kill('SIGKILL'), ended));
  const [port, monitorPort] = await says(node, /client connections on 127\.0\.0\.1:(\d+)/, /http monitor on 127\.0\.0\.1:(\d+)/, /(Server is ready)/);
  Object.assign(node, { url: `${scheme}://127.0.0.1:${port}`, monitor: `http://127.0.0.1:${monitorPort}` });
  if (routes) [node.route] = (await says(node, /route connections on (127\.0\.0\.1:\d+)/)).map((at) => `nats://${at}`);
  return node;
}

/**
 * A cluster: all other servers get the address of the first, which introduces them to each other. `options` as for
 * startNode.
 */
export async function startCluster(t, count = 3, options = {}) {
  const nodes = [await startNode(t, { routes: [], ...options })];
  while (nodes.length < count) nodes.push(await startNode(t, { routes: [nodes[0].route], ...options }));
  await Promise.all(nodes.map((node) => haveRoutes(node, count - 1)));
  return nodes;
}

async function haveRoutes(node, count) {
  const deadline = Date.now() + startWithin_ms;
  const routes = async () => (await (await fetch(`${node.monitor}/routez`)).json()).routes?.length ?? 0;
  while (await routes() < count) {
    if (Date.now() > deadline) throw new Error(`nats-server: ${node.log}`);
    await delay(50);
  }
}
