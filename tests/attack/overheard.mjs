// SPDX-License-Identifier: Apache-2.0
// What real programs and a hub say to each other, overheard by a proxy: sessions to attack with.
import { once } from 'node:events';

import { WebSocket, WebSocketServer } from '../network/npm.mjs';

const subprotocol = 'roomcast.v1';
const mostBytes = 8_000_000; // of a session's direction

/** A WebSocket proxy in front of a hub that keeps every session. */
export class Proxy {
  sessions = []; // {fromClient: [Buffer...], fromHub: [Buffer...]}

  static async start(t, hubUrl) {
    const server = new WebSocketServer({ port: 0, host: '127.0.0.1', handleProtocols: () => subprotocol });
    await once(server, 'listening');
    t.after(() => (server.clients.forEach((client) => client.terminate()), server.close()));
    return new Proxy(server, hubUrl);
  }

  constructor(server, hubUrl) {
    this.url = `ws://127.0.0.1:${server.address().port}`;
    server.on('connection', (client) => this.#join(client, new WebSocket(`${hubUrl}/ws`, subprotocol, { perMessageDeflate: false })));
  }

  #join(client, hub) {
    const session = { fromClient: [], fromHub: [] };
    this.sessions.push(session);
    const opened = once(hub, 'open');
    forward(client, hub, session.fromClient, opened);
    forward(hub, client, session.fromHub, Promise.resolve());
    [client, hub].forEach((end) => end.on('error', () => {}).on('close', () => (client.terminate(), hub.terminate())));
  }
}

function forward(from, to, kept, whenReady) {
  let bytes = 0;
  from.on('message', async (data) => {
    bytes += data.length;
    if (bytes < mostBytes) kept.push(Buffer.from(data));
    await whenReady;
    to.send(data);
  });
}
