// SPDX-License-Identifier: Apache-2.0
// Writes recordings of small sensors without colour, so that a test can run many real programs on few cores.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';

const width = 64;
const height = 48;

const camera = {
  depth: { width, height, fx: 60, fy: 60, cx: 31.5, cy: 23.5 },
  depth_scale_to_metre: 0.001,
  invalid_depth: [0],
};

/** Two metres from the middle of the room, 1.5 m high, looking across the room. */
function worldFromDepth(sensor) {
  const angle = (sensor * Math.PI) / 2;
  const [sin, cos] = [Math.round(Math.sin(angle)), Math.round(Math.cos(angle))];
  const right = [cos, 0, -sin];
  const down = [0, -1, 0];
  const forward = [-sin, 0, -cos];
  const place = [2 * sin, 1.5, 2 * cos];
  return [...[0, 1, 2].flatMap((row) => [right[row], down[row], forward[row], place[row]]), 0, 0, 0, 1];
}

/** Four sensors, two seconds at `fps`, with clocks that are seconds apart. Returns the rig's path in `folder`. */
export function writeSmallRig(folder, { fps = 10 } = {}) {
  const sensors = [0, 3.25, 6.5, 9.75].map((clockOffset_s, n) => ({
    entry: { id: `s${n}`, clock_offset_s: clockOffset_s },
    frames: Array.from({ length: 2 * fps }, (_, i) => ({
      stamp: (100 + i / fps + clockOffset_s).toFixed(6),
      file: `depth/${String(i).padStart(6, '0')}.png`,
    })),
  }));
  return writeRig(folder, fps, sensors);
}

/** Small sensors with the timing of another rig: its clocks, drift and lost frames. */
export function writeSmallRigTimedAs(rig, folder) {
  const { fps, sensors } = JSON.parse(readFileSync(join(rig, 'rig.json'), 'utf8'));
  const framesOf = ({ path }) =>
    readFileSync(join(rig, path, 'depth.txt'), 'utf8')
      .split('\n')
      .filter((line) => line !== '' && !line.startsWith('#'))
      .map((line) => ({ stamp: line.split(' ')[0], file: line.split(' ')[1] }));
  return writeRig(folder, fps, sensors.map((entry) => ({ entry, frames: framesOf(entry) })));
}

function writeRig(folder, fps, sensors) {
  const rig = join(folder, 'rig');
  sensors.forEach(({ frames }, n) => writeSensor(join(rig, `s${n}`), n, frames));
  const entries = sensors.map(({ entry }, n) => ({ ...entry, path: `s${n}`, world_from_depth: worldFromDepth(n) }));
  writeFileSync(join(rig, 'rig.json'), JSON.stringify({ version: 1, fps, sensors: entries }));
  return rig;
}

function writeSensor(folder, n, frames) {
  mkdirSync(join(folder, 'depth'), { recursive: true });
  writeFileSync(join(folder, 'camera.json'), JSON.stringify(camera));
  frames.forEach(({ file }, i) => writeFileSync(join(folder, file), depthPng((x, y) => 1500 + 100 * n + 10 * i + x + y)));
  const lines = frames.map(({ stamp, file }) => `${stamp} ${file}\n`);
  writeFileSync(join(folder, 'depth.txt'), `# timestamp path\n${lines.join('')}`);
}

function depthPng(depthAt_mm) {
  const rows = Buffer.alloc(height * (1 + 2 * width));
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) rows.writeUInt16BE(depthAt_mm(x, y), y * (1 + 2 * width) + 1 + 2 * x);
  }
  return pngOf(16, 0, deflateSync(rows));
}

/** A PNG of this size, rows without filter, `colorType` 0 grey and 2 RGB: PNG specification, sections 5 and 11. */
export function pngOf(bits, colorType, data) {
  const header = Buffer.from([0, 0, 0, 0, 0, 0, 0, 0, bits, colorType, 0, 0, 0]);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([signature, chunk('IHDR', header), chunk('IDAT', data), chunk('IEND', Buffer.alloc(0))]);
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const result = Buffer.alloc(body.length + 8);
  result.writeUInt32BE(data.length, 0);
  body.copy(result, 4);
  result.writeUInt32BE(crc32(body), body.length + 4);
  return result;
}

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}
