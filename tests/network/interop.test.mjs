// SPDX-License-Identifier: Apache-2.0
// The hub against an independent WebSocket implementation, npm's ws, plain and encrypted, per RFC 6455. Frames that the
// library refuses to send are written to its socket directly.
import assert from 'node:assert/strict';
import { randomBytes } from 'node:crypto';
import { once } from 'node:events';
import { describe, test } from 'node:test';

import { scratchFolder, startHub } from '../cli/program.mjs';
import { writeJoin } from './messages.mjs';
import { WebSocket } from './npm.mjs';
import { RoomClient, SendingSensor } from './room_client.mjs';
import { assertMissedNothing } from './rooms.mjs';

const opcodes = { continuation: 0, text: 1, binary: 2, close: 8, ping: 9, pong: 10 };
const normal = 1000;
const protocolError = 1002;
const unacceptable = 1003;
const tooLarge = 1009;

/** A client frame per RFC 6455 section 5.2, with the requested faults. */
function rawFrame(opcode, payload, { fin = true, masked = true, reserved = 0 } = {}) {
  const mask = masked ? randomBytes(4) : Buffer.alloc(0);
  const length = payload.length < 126 ? Buffer.from([payload.length]) : Buffer.from([126, payload.length >> 8, payload.length & 255]);
  length[0] |= masked ? 0x80 : 0;
  const body = masked ? payload.map((byte, i) => byte ^ mask[i % 4]) : payload;
  return Buffer.concat([Buffer.from([(fin ? 0x80 : 0) | reserved | opcode]), length, mask, body]);
}

function sendRaw(client, ...frames) {
  client.socket._socket.write(Buffer.concat(frames));
}

const closePayload = (code, reason = '') => {
  const payload = Buffer.from(`..${reason}`);
  payload.writeUInt16BE(code, 0);
  return payload;
};

const transports = {
  'in the clear': { hubOptions: () => [], scheme: 'ws', options: {} },
  encrypted: {
    hubOptions: (t) => ['--tls-self-signed', '--data', scratchFolder(t)],
    scheme: 'wss',
    options: { rejectUnauthorized: false },
  },
};

for (const [name, { hubOptions, scheme, options }] of Object.entries(transports)) {
  describe(`a client made of npm's ws, ${name}`, () => {
    const start = async (t) => {
      const hub = await startHub(t, ...hubOptions(t));
      return { ...hub, url: `${scheme}://127.0.0.1:${hub.port}` };
    };
    const open = async (t) => RoomClient.open(t, (await start(t)).url, options);

    test('agrees_on_the_subprotocol_and_on_no_extension', async (t) => {
      const hub = await start(t);
      const client = await RoomClient.open(t, hub.url, { ...options, perMessageDeflate: true });
      assert.equal(client.socket.protocol, 'roomcast.v1');
      assert.equal(client.socket.extensions, '');
      const other = new WebSocket(`${hub.url}/ws`, 'roomcast.v99', options);
      const [error] = await once(other, 'error');
      assert.match(error.message, /4\d\d|subprotocol/);
    });

    test('sends_and_receives_frames_of_all_sizes', async (t) => {
      const { url } = await start(t);
      const ids = [];
      for (const [i, payloadBytes] of [0, 60, 100, 65_470, 65_500, 1_000_000].entries()) {
        const sensor = await SendingSensor.start(t, url, { name: `${payloadBytes}`, fps: 5, payloadBytes, options });
        assert.equal(sensor.client.welcome.sensorId, i);
        ids.push(i);
      }
      const viewer = await RoomClient.join(t, url, { options });
      await viewer.until('three frames of each', () => ids.every((id) => viewer.seqsOf(id).length >= 3));
      assertMissedNothing(viewer, ids);
    });

    test('pings_are_answered_with_their_payload_while_frames_flow', async (t) => {
      const { url } = await start(t);
      await SendingSensor.start(t, url, { name: 'left', fps: 30, payloadBytes: 100_000, options });
      const viewer = await RoomClient.join(t, url, { options });
      const answers = [];
      viewer.socket.on('pong', (data) => answers.push(data.toString('utf8')));
      for (let i = 0; i < 20; ++i) {
        viewer.socket.ping(`ping ${i}`);
        await viewer.until('the pong', () => answers.at(-1) === `ping ${i}`);
        await viewer.moreSets(1);
      }
      viewer.socket.ping(Buffer.alloc(125, 'x'));
      await viewer.until('the longest pong', () => answers.at(-1).length === 125);
      assertMissedNothing(viewer, [0]);
    });

    test('message_in_fragments_is_one_message_with_a_ping_in_between', async (t) => {
      const client = await open(t);
      let pongs = 0;
      client.socket.on('pong', () => ++pongs);
      const join = writeJoin({ name: 'in pieces' });
      const pieces = [join.subarray(0, 3), join.subarray(3, 7), join.subarray(7)];
      sendRaw(
        client,
        rawFrame(opcodes.binary, pieces[0], { fin: false }),
        rawFrame(opcodes.continuation, pieces[1], { fin: false }),
        rawFrame(opcodes.ping, Buffer.from('between')),
        rawFrame(opcodes.continuation, pieces[2]),
      );
      await client.until('welcome and pong', () => client.welcome && pongs === 1);
    });

    const broken = {
      ping_in_fragments: [protocolError, rawFrame(opcodes.ping, Buffer.from('a'), { fin: false })],
      close_in_fragments: [protocolError, rawFrame(opcodes.close, closePayload(normal), { fin: false })],
      ping_of_126_bytes: [protocolError, rawFrame(opcodes.ping, Buffer.alloc(126))],
      continuation_of_nothing: [protocolError, rawFrame(opcodes.continuation, Buffer.from('a'))],
      message_inside_a_message: [
        protocolError,
        Buffer.concat([
          rawFrame(opcodes.binary, Buffer.from('a'), { fin: false }),
          rawFrame(opcodes.binary, Buffer.from('b')),
        ]),
      ],
      frame_without_a_mask: [protocolError, rawFrame(opcodes.binary, Buffer.from('a'), { masked: false })],
      reserved_bit: [protocolError, rawFrame(opcodes.binary, Buffer.from('a'), { reserved: 0x40 })],
      unknown_opcode: [protocolError, rawFrame(3, Buffer.from('a'))],
      close_with_a_code_that_may_not_be_sent: [protocolError, rawFrame(opcodes.close, closePayload(1005))],
      close_with_half_a_code: [protocolError, rawFrame(opcodes.close, Buffer.from([3]))],
      text: [unacceptable, rawFrame(opcodes.text, Buffer.from('hello'))],
      message_that_is_too_large: [tooLarge, rawFrame(opcodes.binary, Buffer.alloc(20_000))],
    };
    for (const [fault, [code, bytes]] of Object.entries(broken)) {
      test(`is_refused_with_${code}_for_a_${fault}`, async (t) => {
        const client = await open(t);
        sendRaw(client, bytes);
        const end = await client.closed;
        assert.equal(end.code, code, end.reason);
        assert.match(end.reason, /\w+ \w+/, 'the reason is a sentence');
      });
    }

    test('close_is_answered_with_the_same_code', async (t) => {
      const { url } = await start(t);
      for (const [code, reason] of [[normal, 'bye'], [1001, ''], [4321, 'for reasons of its own']]) {
        const client = await RoomClient.join(t, url, { options });
        client.socket.close(code, reason);
        assert.equal((await client.closed).code, code);
      }
    });

    test('close_without_a_code_is_answered', async (t) => {
      const client = await open(t);
      client.socket.close();
      const noCode = 1005;
      assert.ok([noCode, normal].includes((await client.closed).code));
    });

    test('hub_that_stops_says_so_to_everyone', async (t) => {
      const hub = await start(t);
      const viewer = await RoomClient.join(t, hub.url, { options });
      const stranger = await RoomClient.open(t, hub.url, options);
      hub.program.child.kill('SIGTERM');
      for (const client of [viewer, stranger]) {
        const { code, reason } = await client.closed;
        assert.equal(code, 1001);
        assert.match(reason, /stop|shut/);
      }
      assert.equal(await hub.program.ended, 0);
    });
  });
}
