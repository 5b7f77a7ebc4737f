// SPDX-License-Identifier: Apache-2.0
// A NATS cluster on loopback: real servers on free ports, with the settings that docs/scale.md tells people to use.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { connect } from 'node:net';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as delay } from 'node:timers/promises';

import { scratchFolder } from '../cli/program.mjs';
import { freePort } from './nginx.mjs';

const env = { ...process.env, PATH: `${process.env.PATH}:/usr/sbin` }; // where Debian has it, not in everyone's path
const startWithin_ms = 10_000;

/** False, or the sentence for a test that needs it. */
export const natsIsMissing = spawnSync('nats-server', ['--version'], { env }).error
  ? 'nats-server is not installed (scripts/setup test)'
  : false;

async function listens(port, node) {
  const deadline = Date.now() + startWithin_ms;
  for (;;) {
    const socket = connect(port, '127.0.0.1').on('error', () => {});
    const open = await Promise.race([once(socket, 'data').then(() => true), delay(200, false)]).catch(() => false);
    socket.destroy();
    if (open) return;
    if (node.child.exitCode !== null || Date.now() > deadline) throw new Error(`nats-server: ${node.complaints}`);
    await delay(50);
  }
}

/** One server, until the test ends. `more` is added to its configuration. */
export async function startNode(t, { port, routesPort, routes = [], more = '', scheme = 'nats' }) {
  const folder = scratchFolder(t);
  const monitorPort = await freePort();
  const cluster = routesPort
    ? `cluster { name: roomcast, listen: "127.0.0.1:${routesPort}", no_advertise: true, routes: [${routes.map((p) => `"nats://127.0.0.1:${p}"`).join(', ')}] }`
    : '';
  writeFileSync(
    join(folder, 'nats.conf'),
    `listen: "127.0.0.1:${port}"\nhttp: "127.0.0.1:${monitorPort}"\nping_interval: "1s"\nping_max: 2\nmax_payload: 2MB\nmax_pending: 16MB\n${cluster}\n${more}\n`,
  );
  const child = spawn('nats-server', ['-c', join(folder, 'nats.conf')], { env, stdio: ['ignore', 'ignore', 'pipe'] });
  const node = { child, complaints: '', url: `${scheme}://127.0.0.1:${port}`, monitor: `http://127.0.0.1:${monitorPort}` };
  child.stderr.setEncoding('utf8').on('data', (text) => (node.complaints += text));
  const ended = once(child, 'exit');
  t.after(() => (child.kill('SIGKILL'), ended));
  await listens(port, node);
  return node;
}

/** Servers that know each other. */
export async function startCluster(t, count = 3) {
  const ports = [], routes = [];
  for (let i = 0; i < count; ++i) ports.push(await freePort()), routes.push(await freePort());
  const nodes = await Promise.all(ports.map((port, i) => startNode(t, { port, routesPort: routes[i], routes })));
  await Promise.all(nodes.map((node) => haveRoutes(node, count - 1)));
  return nodes;
}

async function haveRoutes(node, count) {
  const deadline = Date.now() + startWithin_ms;
  const routes = () => new Set([...node.complaints.matchAll(/ - (rid:\d+) - Route connection created/g)].map(([, id]) => id)).size;
  while (routes() < count) {
    if (Date.now() > deadline) throw new Error(`nats-server: ${node.complaints}`);
    await delay(50);
  }
}
