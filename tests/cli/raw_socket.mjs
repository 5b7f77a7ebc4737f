// SPDX-License-Identifier: Apache-2.0
// A client that can send arbitrary bytes: plain TCP, with the WebSocket framing of RFC 6455 written out here.
import { randomBytes } from 'node:crypto';
import { once } from 'node:events';
import { connect } from 'node:net';

/** A TCP connection to a hub. `received` grows; `closed` resolves when the hub ends it. */
export class RawSocket {
  received = Buffer.alloc(0);

  static async open(port) {
    const socket = new RawSocket(connect(port, '127.0.0.1'));
    await once(socket.stream, 'connect');
    return socket;
  }

  constructor(stream) {
    this.stream = stream;
    stream.on('data', (bytes) => (this.received = Buffer.concat([this.received, bytes])));
    stream.on('error', () => {});  // a reset is a valid way to be disconnected
    this.closed = new Promise((resolve) => stream.on('close', resolve));
  }

  send(bytes) {
    this.stream.write(bytes);
  }

  /** Resolves once `done(received)` is true; rejects if the hub closes the connection before. */
  async until(done) {
    while (!done(this.received)) {
      const closed = await Promise.race([once(this.stream, 'data').then(() => false), this.closed.then(() => true)]);
      if (closed && !done(this.received)) throw new Error(`the hub hung up after ${this.received.length} bytes`);
    }
  }

  /** Upgrades the connection to a WebSocket of roomcast.v1. */
  async upgrade() {
    this.send(
      'GET /ws HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n' +
        `Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ${randomBytes(16).toString('base64')}\r\n` +
        'Sec-WebSocket-Protocol: roomcast.v1\r\n\r\n',
    );
    await this.until((bytes) => bytes.includes('\r\n\r\n'));
    if (!this.received.toString('latin1').startsWith('HTTP/1.1 101')) throw new Error(`no upgrade: ${this.received}`);
    this.received = this.received.subarray(this.received.indexOf('\r\n\r\n') + 4);
  }

  /** Sends one masked binary message. */
  sendMessage(payload) {
    const mask = randomBytes(4);
    const header = Buffer.alloc(4);
    header.writeUInt8(0x82, 0);
    header.writeUInt8(0x80 | 126, 1);
    header.writeUInt16BE(payload.length, 2);
    this.send(Buffer.concat([header, mask, payload.map((byte, i) => byte ^ mask[i % 4])]));
  }

  /** Code and reason of the last close frame, after the hub has closed the connection. */
  async closeReason() {
    await this.closed;
    let at = 0;
    while (at + 2 <= this.received.length) {
      const opcode = this.received[at] & 0x0f;
      let length = this.received[at + 1] & 0x7f;
      at += 2;
      if (length === 126) (length = this.received.readUInt16BE(at)), (at += 2);
      else if (length === 127) (length = Number(this.received.readBigUInt64BE(at))), (at += 8);
      const payload = this.received.subarray(at, at + length);
      at += length;
      if (opcode === 8) return { code: payload.readUInt16BE(0), reason: payload.subarray(2).toString('utf8') };
    }
    return null;
  }
}
