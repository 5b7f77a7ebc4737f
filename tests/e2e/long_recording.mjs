// SPDX-License-Identifier: Apache-2.0
// Makes a long recording of a short one: the same seconds again and again, as a complete MCAP file with all checksums
// (https://mcap.dev/spec). For the time that seeking takes; what is seen is of no importance.
import { closeSync, openSync, readFileSync, writeSync } from 'node:fs';

const magic = Buffer.from([0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a]);
const op = { footer: 2, schema: 3, channel: 4, message: 5, chunk: 6, messageIndex: 7, chunkIndex: 8, statistics: 11, metadata: 12, metadataIndex: 13, dataEnd: 15 };

const crcTable = Uint32Array.from({ length: 256 }, (_, i) => {
  for (let bit = 0; bit < 8; bit++) i = i & 1 ? (i >>> 1) ^ 0xedb88320 : i >>> 1;
  return i;
});
function crc32(bytes) {
  let crc = 0xffffffff;
  for (let i = 0; i < bytes.length; i++) crc = crcTable[(crc ^ bytes[i]) & 255] ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

function* recordsOf(bytes) {
  for (let at = 0; at + 9 <= bytes.length; ) {
    const length = Number(bytes.readBigUInt64LE(at + 1));
    yield { opcode: bytes[at], content: bytes.subarray(at + 9, at + 9 + length), whole: bytes.subarray(at, at + 9 + length) };
    at += 9 + length;
  }
}

const u16 = (value) => { const bytes = Buffer.alloc(2); bytes.writeUInt16LE(value); return bytes; };
const u32 = (value) => { const bytes = Buffer.alloc(4); bytes.writeUInt32LE(value); return bytes; };
const u64 = (value) => { const bytes = Buffer.alloc(8); bytes.writeBigUInt64LE(BigInt(value)); return bytes; };
const record = (opcode, ...fields) => {
  const content = Buffer.concat(fields);
  return Buffer.concat([Buffer.from([opcode]), u64(content.length), content]);
};
const mapOf = (entries) => Buffer.concat([u32(10 * entries.length), ...entries.flatMap(([key, value]) => [u16(key), u64(value)])]);

/** A chunk's records, later by `shift_ns`; with what its indexes have to say. */
function shifted(records, shift_ns) {
  const bytes = Buffer.from(records);
  const offsets = new Map();
  let [start, end] = [2n ** 63n, 0n];
  let at = 0;
  for (const { opcode, content, whole } of recordsOf(bytes)) {
    if (opcode === op.message) {
      const time = content.readBigUInt64LE(6) + shift_ns;
      content.writeBigUInt64LE(time, 6);
      content.writeBigUInt64LE(content.readBigUInt64LE(14) + shift_ns, 14);
      const channel = content.readUInt16LE(0);
      offsets.set(channel, [...(offsets.get(channel) ?? []), [time, at]]);
      if (time < start) start = time;
      if (time > end) end = time;
    }
    at += whole.length;
  }
  return { bytes, offsets, start, end };
}

/** Writes `to`: `from`, made by roomcast, repeated for at least so many seconds. Returns its length in seconds. */
export function repeatRecording(from, to, seconds) {
  const source = readFileSync(from).subarray(magic.length);
  const kept = [...recordsOf(source)];
  const chunks = kept.filter(({ opcode }) => opcode === op.chunk).map(({ content }) => content.subarray(40));
  const firstChunk = kept.findIndex(({ opcode }) => opcode === op.chunk);
  const summaryFrom = kept.findIndex(({ opcode }) => opcode === op.dataEnd);
  const about = kept.filter(({ opcode }) => opcode === op.schema || opcode === op.channel);
  const out = openSync(to, 'w');
  let at = 0;
  const write = (bytes) => {
    writeSync(out, bytes);
    const where = at;
    at += bytes.length;
    return where;
  };
  write(magic);
  const metadata = [];
  for (const { opcode, content, whole } of kept.slice(0, firstChunk)) {
    const where = write(whole);
    if (opcode !== op.metadata) continue;
    metadata.push(record(op.metadataIndex, u64(where), u64(whole.length), content.subarray(0, 4 + content.readUInt32LE(0))));
  }
  const times = chunks.map((records) => shifted(records, 0n));
  const gap_ns = 50_000_000n; // between two rounds
  const period = times.at(-1).end - times[0].start + gap_ns;
  const rounds = Math.ceil((seconds * 1e9 + Number(gap_ns)) / Number(period));
  const indexes = [];
  const counts = new Map();
  let messages = 0;
  let last = 0n;
  for (let round = 0; round < rounds; round++) {
    for (const records of chunks) {
      const { bytes, offsets, start, end } = shifted(records, BigInt(round) * period);
      const fields = [u64(start), u64(end), u64(bytes.length), u32(crc32(bytes)), u32(0), u64(bytes.length), bytes];
      const chunk = record(op.chunk, ...fields);
      const where = write(chunk);
      const entries = [];
      const first = at;
      for (const [channel, list] of offsets) {
        const pairs = list.flatMap(([time, offset]) => [u64(time), u64(offset)]);
        entries.push([channel, write(record(op.messageIndex, u16(channel), u32(16 * list.length), ...pairs))]);
        counts.set(channel, (counts.get(channel) ?? 0) + list.length);
        messages += list.length;
      }
      indexes.push(record(op.chunkIndex, u64(start), u64(end), u64(where), u64(chunk.length), mapOf(entries), u64(at - first), u32(0), u64(bytes.length), u64(bytes.length)));
      last = end;
    }
  }
  write(record(op.dataEnd, u32(0)));
  const ofKind = (opcode) => kept.slice(summaryFrom).filter((each) => each.opcode === opcode).map(({ whole }) => whole);
  const sizes = [u16(ofKind(op.schema).length), u32(counts.size), u32(0), u32(metadata.length), u32(indexes.length)];
  const statistics = record(op.statistics, u64(messages), ...sizes, u64(times[0].start), u64(last), mapOf([...counts]));
  const start = at;
  const summary = Buffer.concat([...ofKind(op.schema), ...ofKind(op.channel), statistics, ...indexes, ...metadata]);
  const footer = Buffer.concat([Buffer.from([op.footer]), u64(20), u64(start), u64(0)]);
  write(summary);
  write(Buffer.concat([footer, u32(crc32(Buffer.concat([summary, footer]))), magic]));
  closeSync(out);
  if (about.length === 0) throw new Error(`${from} has no channels`);
  return Number(last - times[0].start) / 1e9;
}
