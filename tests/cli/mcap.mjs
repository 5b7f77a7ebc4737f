// SPDX-License-Identifier: Apache-2.0
// Reads MCAP files with the format's own library (npm @mcap/core).
import { open, readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../web/package.json', import.meta.url));
export const { McapIndexedReader, McapStreamReader, McapWriter } = require('@mcap/core');
export const { BinaryReader } = require('@bufbuild/protobuf/wire');

/** Gives random access to the bytes of a file. */
async function readable(path) {
  const file = await open(path);
  const { size } = await file.stat();
  return {
    close: () => file.close(),
    size: async () => BigInt(size),
    read: async (offset, length) => {
      const bytes = new Uint8Array(Number(length));
      await file.read(bytes, 0, bytes.length, Number(offset));
      return bytes;
    },
  };
}

/** Reads a complete file through its index. Returns `{ summary, messages }`; each message has its topic. */
export async function readIndexed(path) {
  const source = await readable(path);
  try {
    const reader = await McapIndexedReader.Initialize({ readable: source });
    const messages = [];
    for await (const message of reader.readMessages()) {
      const { topic } = reader.channelsById.get(message.channelId);
      messages.push({ ...message, topic });
    }
    const metadata = [];
    for await (const record of reader.readMetadata()) metadata.push(record);
    return { reader, messages, metadata };
  } finally {
    await source.close();
  }
}

/** Reads as much as possible of a file that may be truncated anywhere. */
export async function readFromStart(path) {
  const reader = new McapStreamReader();
  reader.append(await readFile(path));
  const topics = new Map();
  const messages = [];
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === 'Channel') topics.set(record.id, record.topic);
    if (record.type === 'Message') messages.push({ ...record, topic: topics.get(record.channelId) });
  }
  return { messages, whole: reader.done() };
}

export function isFrame({ topic }) {
  return topic.startsWith('/sensor/') && topic.endsWith('/frame');
}

/** Parses a frame message's header (docs/spec/wire.md §2) and payload. */
export function parseFrame(data) {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const headerLength = view.getUint16(4, true);
  return {
    magic: view.getUint16(0, true),
    key: (view.getUint16(6, true) & 1) === 1,
    seq: view.getUint32(12, true),
    captureNs: view.getBigInt64(24, true),
    payload: Buffer.from(data.subarray(headerLength)),
  };
}
