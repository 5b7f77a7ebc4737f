// SPDX-License-Identifier: Apache-2.0
// Very many encrypted connections from many addresses come and go: the memory that they took does not stay with the hub.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { connect } from 'node:tls';

import { scratchFolder, Program } from '../cli/program.mjs';

const addresses = 40; // 127.0.0.2 and on: a hub counts connections by address
const ofEachAddress = 40;
const atATime = 50;
const releasedWithin_ms = 20_000;
const leastGrowth_mb = 8; // with the flood
const mostKept = 0.5; // of that growth, after it

function memoryOf_mb(pid) {
  return Number(/VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1]) / 1000;
}

function connectFrom(localAddress, port) {
  return new Promise((resolve) => {
    const socket = connect({ host: '127.0.0.1', port, localAddress, rejectUnauthorized: false });
    socket.once('secureConnect', () => resolve(socket));
    socket.once('error', () => resolve(socket));
  });
}

/** Opens so many connections that say nothing, some at a time. */
async function flood(port) {
  const sockets = [];
  let begun = 0;
  const openInTurn = async () => {
    while (begun < addresses * ofEachAddress) {
      sockets.push(await connectFrom(`127.0.0.${2 + (begun++ % addresses)}`, port));
    }
  };
  await Promise.all(Array.from({ length: atATime }, openInTurn));
  return sockets;
}

test('memory_of_a_flood_of_connections_does_not_stay', { timeout: 90_000 }, async (t) => {
  const hub = new Program(['hub', '--listen', '127.0.0.1:0', '--tls-self-signed', '--no-align', '--data', scratchFolder(t)], { limitMs: 90_000 });
  t.after(() => hub.stop('SIGKILL'));
  const port = await hub.port();
  const before_mb = memoryOf_mb(hub.child.pid);
  const sockets = await flood(port);
  const flooded_mb = memoryOf_mb(hub.child.pid);
  sockets.forEach((socket) => socket.destroy());
  const most_mb = before_mb + mostKept * (flooded_mb - before_mb);
  let after_mb = flooded_mb;
  for (const begin = performance.now(); performance.now() - begin < releasedWithin_ms; await delay(500)) {
    after_mb = memoryOf_mb(hub.child.pid);
    if (after_mb < most_mb) break;
  }
  t.diagnostic(`${before_mb.toFixed(0)} MB before, ${flooded_mb.toFixed(0)} with the flood, ${after_mb.toFixed(0)} after it`);
  assert.ok(flooded_mb > before_mb + leastGrowth_mb, 'the flood took memory');
  assert.ok(after_mb < most_mb, `${after_mb} MB stay`);
});
