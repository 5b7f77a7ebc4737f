// SPDX-License-Identifier: Apache-2.0
// The messages of roomcast.v1 per docs/spec/wire.md and roomcast/wire/control.proto, implemented again independently of
// the two implementations under test. Covers only the messages used by these tests.
import { BinaryReader, BinaryWriter, WireType } from './npm.mjs';

const magic = 0x4352;
const version = 1;
const preambleBytes = 4;
const headerBytes = 48;
const messageTypes = { frame: 1, control: 2 };
const controls = { placements: 12, join: 1, welcome: 2, roster: 3, keyRequest: 4, clockPing: 5, clockPong: 6, viewerPose: 7, viewerPoses: 8, error: 10, otherHubs: 17 };
const flagKey = 1;
const flagLast = 2;

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function preamble(bytes, type) {
  bytes.writeUInt16LE(magic, 0);
  bytes.writeUInt8(version, 2);
  bytes.writeUInt8(type, 3);
}

/** A complete frame message. Every frame is a key frame; the payload is arbitrary, because a hub does not decode it. */
export function writeFrame({ sensor, seq, captureNs, payload }) {
  const message = Buffer.alloc(headerBytes + payload.length);
  preamble(message, messageTypes.frame);
  message.writeUInt16LE(headerBytes, 4);
  message.writeUInt16LE(flagKey, 6);
  message.writeUInt16LE(sensor, 8);
  message.writeUInt8(1, 11);
  message.writeUInt32LE(seq, 12);
  message.writeBigInt64LE(captureNs, 24);
  message.writeUInt32LE(seq, 36);
  message.writeUInt32LE(payload.length, 40);
  payload.copy(message, headerBytes);
  return message;
}

/** Returns {frame} or {control: {case, ...}}; throws on any other message. */
export function readMessage(bytes) {
  if (bytes.readUInt16LE(0) !== magic || bytes.readUInt8(2) !== version) throw new Error('this is not roomcast.v1');
  if (bytes.readUInt8(3) === messageTypes.control) return { control: readControl(bytes.subarray(preambleBytes)) };
  return { frame: readFrameHeader(bytes) };
}

function readFrameHeader(bytes) {
  const length = bytes.readUInt16LE(4);
  const flags = bytes.readUInt16LE(6);
  const payloadLength = bytes.readUInt32LE(40);
  if (length + payloadLength !== bytes.length) throw new Error('a frame of another length than it says');
  return {
    key: (flags & flagKey) !== 0,
    last: (flags & flagLast) !== 0,
    sensor: bytes.readUInt16LE(8),
    layer: bytes.readUInt8(10),
    seq: bytes.readUInt32LE(12),
    set: Number(bytes.readBigUInt64LE(16)),
    captureNs: bytes.readBigInt64LE(24),
    clockErrorUs: bytes.readUInt32LE(32),
    baseSeq: bytes.readUInt32LE(36),
  };
}

function control(number, write) {
  const writer = new BinaryWriter().tag(number, WireType.LengthDelimited).fork();
  write(writer);
  const body = writer.join().finish();
  const message = Buffer.alloc(preambleBytes + body.length);
  preamble(message, messageTypes.control);
  message.set(body, preambleBytes);
  return message;
}

/** Join as a viewer, as `sensor` {fps, worldFromDepth}, or as an aligner. */
export function writeJoin({ room, name, sensor, aligner, token, code, redirected }) {
  return control(controls.join, (join) => {
    if (room) join.tag(1, WireType.LengthDelimited).string(room);
    join.tag(2, WireType.LengthDelimited).string(name);
    if (token) join.tag(6, WireType.LengthDelimited).string(token);
    if (code) join.tag(7, WireType.LengthDelimited).string(code);
    if (redirected) join.tag(8, WireType.Varint).bool(true);
    join.tag(sensor ? 3 : aligner ? 5 : 4, WireType.LengthDelimited).fork();
    if (sensor) writeSensorRole(join, sensor);
    join.join();
  });
}

function writeSensorRole(role, { fps, worldFromDepth = identity }) {
  role.tag(1, WireType.LengthDelimited).fork();
  writeCalibration(role);
  role.join();
  role.tag(2, WireType.Bit64).double(fps);
  writeMatrix(role, 3, worldFromDepth);
}

function writeCalibration(calibration) {
  for (const camera of [1, 2]) {
    calibration.tag(camera, WireType.LengthDelimited).fork();
    calibration.tag(1, WireType.Varint).uint32(64).tag(2, WireType.Varint).uint32(48);
    [60, 60, 32, 24].forEach((value, i) => calibration.tag(3 + i, WireType.Bit64).double(value));
    calibration.join();
  }
  writeMatrix(calibration, 3, identity);
  calibration.tag(4, WireType.Varint).bool(true);
}

function writeMatrix(writer, number, matrix) {
  writer.tag(number, WireType.LengthDelimited).fork();
  matrix.forEach((value) => writer.double(value));
  writer.join();
}

/** Reports the estimated pose of a sensor. */
export function writePlacement({ sensor, worldFromDepth }) {
  return control(controls.placements, (placements) => {
    const placement = placements.tag(1, WireType.LengthDelimited).fork();
    placement.tag(1, WireType.Varint).uint32(sensor);
    writeMatrix(placement, 2, worldFromDepth);
    placement.tag(5, WireType.Varint).uint32(1).join();
  });
}

/** A viewer's head at [x, y, z] that looks along -z. */
export function writeViewerPose(place_m) {
  return control(controls.viewerPose, (pose) => {
    const head = pose.tag(2, WireType.LengthDelimited).fork();
    place_m.forEach((metres, i) => head.tag(1 + i, WireType.Bit32).float(metres));
    head.tag(7, WireType.Bit32).float(1).join();
  });
}

export function writeClockPing(clientNs) {
  return control(controls.clockPing, (ping) => ping.tag(1, WireType.Bit64).fixed64(clientNs));
}

/** Calls `field(number)` for every field of a message; skips fields that it does not read. */
function readFields(bytes, field) {
  const reader = new BinaryReader(bytes);
  while (reader.pos < reader.len) {
    const [number, wireType] = reader.tag();
    const before = reader.pos;
    field(number, reader);
    if (reader.pos === before) reader.skip(wireType);
  }
}

function readControl(bytes) {
  let message = { case: 'unknown' };
  readFields(bytes, (number, reader) => {
    const name = Object.keys(controls).find((key) => controls[key] === number);
    const read = { welcome: readWelcome, roster: readRoster, clockPong: readPong, viewerPoses: readPoses, error: readError, otherHubs: readOtherHubs }[name];
    if (name) message = { case: name, ...read?.(reader.bytes()) };
  });
  return message;
}

function readWelcome(bytes) {
  const welcome = { sensorId: 0, viewerId: 0, token: '' };
  readFields(bytes, (number, reader) => {
    if (number === 2) welcome.sensorId = reader.uint32();
    if (number === 3) welcome.viewerId = reader.uint32();
    if (number === 6) welcome.token = reader.string();
  });
  return welcome;
}

function readRoster(bytes) {
  const roster = { sensors: [], people: [], viewers: 0 }; // viewers: at this hub
  readFields(bytes, (number, reader) => {
    if (number === 3) roster.sensors.push(readSensorEntry(reader.bytes()));
    if (number === 4) roster.people.push(readViewerEntry(reader.bytes()));
  });
  roster.viewers = roster.people.filter(({ hubsAway }) => hubsAway === 0).length;
  return roster;
}

function readViewerEntry(bytes) {
  const entry = { id: 0, name: '', hubsAway: 0 };
  readFields(bytes, (number, reader) => {
    if (number === 1) entry.id = reader.uint32();
    if (number === 2) entry.name = reader.string();
    if (number === 4) entry.hubsAway = reader.uint32();
  });
  return entry;
}

function readSensorEntry(bytes) {
  const entry = { id: 0, name: '', online: false, worldFromDepth: [], placement: 0, moved: false, unverified: false };
  readFields(bytes, (number, reader) => {
    if (number === 1) entry.id = reader.uint32();
    if (number === 2) entry.name = reader.string();
    if (number === 3) entry.online = reader.bool();
    if (number === 5) entry.worldFromDepth = readDoubles(Buffer.from(reader.bytes()));
    if (number === 6) entry.placement = reader.uint32();
    if (number === 10) entry.moved = reader.bool();
    if (number === 11) entry.unverified = reader.bool();
  });
  return entry;
}

function readDoubles(bytes) {
  return Array.from({ length: bytes.length / 8 }, (_, i) => bytes.readDoubleLE(8 * i));
}

function readOtherHubs(bytes) {
  const urls = [];
  readFields(bytes, (number, reader) => number === 1 && urls.push(reader.string()));
  return { urls };
}

function readPong(bytes) {
  const pong = {};
  readFields(bytes, (number, reader) => {
    if (number === 1) pong.clientNs = BigInt(reader.fixed64());
    if (number === 2) pong.hubNs = BigInt(reader.fixed64());
  });
  return pong;
}

/** The position of each viewer's head, [x, y, z], and the viewers in the same order. */
function readPoses(bytes) {
  const heads = [], ids = [];
  readFields(bytes, (number, reader) => {
    if (number === 1) readHead(reader.bytes(), heads, ids);
  });
  return { heads, ids };
}

function readHead(bytes, heads, ids) {
  const place_m = [0, 0, 0];
  let id = 0;
  readFields(bytes, (number, reader) => {
    if (number === 1) id = reader.uint32();
    if (number === 2) readPlace(reader.bytes(), place_m);
  });
  heads.push(place_m);
  ids.push(id);
}

function readPlace(bytes, place_m) {
  readFields(bytes, (number, reader) => {
    if (number <= 3) place_m[number - 1] = reader.float();
  });
}

function readError(bytes) {
  const error = { code: 0, sentence: '' };
  readFields(bytes, (number, reader) => {
    if (number === 1) error.code = reader.int32();
    if (number === 2) error.sentence = reader.string();
  });
  return error;
}
