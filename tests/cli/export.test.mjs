// SPDX-License-Identifier: Apache-2.0
// Reads every export with third-party readers, and checks that it contains the points of the recording's pictures.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { writeSmallRig } from '../network/small_rig.mjs';
import { readIndexed } from './mcap.mjs';
import { Program, assertFailed, run, scratchFolder } from './program.mjs';

const require = createRequire(new URL('../../web/package.json', import.meta.url));
const { PLYLoader } = await import(require.resolve('three/examples/jsm/loaders/PLYLoader.js'));
const { PCDLoader } = await import(require.resolve('three/examples/jsm/loaders/PCDLoader.js'));
const { OBJLoader } = await import(require.resolve('three/examples/jsm/loaders/OBJLoader.js'));
const { NodeIO } = require('@gltf-transform/core');
const validator = require('gltf-validator');
const { createFileRegistry, fromBinary } = require('@bufbuild/protobuf');
const { FileDescriptorSetSchema } = require('@bufbuild/protobuf/wkt');
const { foxgloveMessageSchemas } = require('@foxglove/schemas/internal');

const cleanups = [];
after(() => cleanups.forEach((cleanup) => cleanup()));
let rig;
before(() => {
  rig = writeSmallRig(scratchFolder({ after: (cleanup) => cleanups.push(cleanup) }), { fps: 5 });
});

async function exportRig(t, format, ...options) {
  const out = join(scratchFolder(t), 'out');
  const result = await run('export', rig, '--format', format, '--out', out, '--json', ...options);
  assert.equal(result.code, 0, result.stderr);
  return { out, totals: JSON.parse(result.stdout) };
}

/** The world points of the pictures at instant `i`, computed from their formula for all pixels but the border. */
function truePoints(i) {
  const { sensors } = JSON.parse(readFileSync(join(rig, 'rig.json'), 'utf8'));
  return sensors.flatMap(({ world_from_depth: m }, n) => {
    const points = [];
    for (let y = 1; y < 47; ++y) {
      for (let x = 1; x < 63; ++x) {
        const z = (1500 + 100 * n + 10 * i + x + y) / 1000;
        const p = [((x - 31.5) / 60) * z, ((y - 23.5) / 60) * z, z];
        points.push([0, 1, 2].map((row) => m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3]));
      }
    }
    return points;
  });
}

const precision_m = 1e-5;

function assertSamePoints(positions, truth) {
  assert.equal(positions.length, 3 * truth.length);
  truth.forEach((point, i) => {
    for (let axis = 0; axis < 3; ++axis) {
      assert.ok(Math.abs(positions[3 * i + axis] - point[axis]) < precision_m, `point ${i} of ${truth.length}`);
    }
  });
}

function arrayBuffer(file) {
  const bytes = readFileSync(file);
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
}

test('ply_holds_the_points_and_normals', async (t) => {
  const { out, totals } = await exportRig(t, 'ply', '--keep-doubles');
  assert.equal(totals.sets, 10);
  for (const i of [0, 9]) {
    const geometry = new PLYLoader().parse(arrayBuffer(join(out, `set_00000${i}.ply`)));
    assertSamePoints(geometry.getAttribute('position').array, truePoints(i));
    const normals = geometry.getAttribute('normal');
    for (let n = 0; n < normals.count; ++n) {
      assert.ok(Math.abs(Math.hypot(normals.getX(n), normals.getY(n), normals.getZ(n)) - 1) < 1e-5);
    }
    assert.ok(geometry.getAttribute('color'));
  }
});

test('pcd_holds_the_points', async (t) => {
  const { out } = await exportRig(t, 'pcd', '--keep-doubles', '--every', '9');
  assert.deepEqual(readdirSync(out).sort(), ['set_000000.pcd', 'set_000009.pcd']);
  const { geometry } = new PCDLoader().parse(arrayBuffer(join(out, 'set_000009.pcd')));
  assertSamePoints(geometry.getAttribute('position').array, truePoints(9));
});

test('gltf_is_valid_and_its_meshes_have_the_points', async (t) => {
  const { out } = await exportRig(t, 'gltf', '--to', '0.1');
  const file = join(out, 'set_000000.glb');
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)));
  assert.equal(report.issues.numErrors, 0, JSON.stringify(report.issues.messages));
  const document = await new NodeIO().read(file);
  const nodes = document.getRoot().listNodes();
  assert.deepEqual(nodes.map((node) => node.getName()), ['s0', 's1', 's2', 's3']);
  nodes.forEach((node, n) => {
    const position = node.getMesh().listPrimitives()[0].getAttribute('POSITION');
    assert.equal(position.getCount(), 64 * 48);
    for (let i = 0; i < position.getCount(); ++i) {
      const [x, y, z] = position.getElement(i, []);
      // The vertex is on the ray of a pixel, at that pixel's depth.
      const [px, py] = [(x / z) * 60 + 31.5, (y / z) * 60 + 23.5];
      assert.ok(Math.abs(px - Math.round(px)) < 1e-3 && Math.abs(py - Math.round(py)) < 1e-3);
      assert.ok(Math.abs(z - (1500 + 100 * n + Math.round(px) + Math.round(py)) / 1000) < precision_m);
    }
  });
});

/** What Google's own decoder finds in the Draco data of a GLB: `{ points, triangles, positions }`. */
async function readDraco(file) {
  const bytes = readFileSync(file);
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
  const primitive = json.meshes[0].primitives[0];
  const { bufferView, attributes } = primitive.extensions.KHR_draco_mesh_compression;
  const view = json.bufferViews[bufferView];
  const begin = 20 + bytes.readUInt32LE(12) + 8 + (view.byteOffset ?? 0);
  const script = readFileSync(new URL('../../web/node_modules/three/examples/jsm/libs/draco/draco_decoder.js', import.meta.url), 'utf8');
  const draco = await new Function('require', '__dirname', `${script}; return DracoDecoderModule`)(require, '')({});
  const buffer = new draco.DecoderBuffer();
  buffer.Init(new Int8Array(bytes.subarray(begin, begin + view.byteLength)), view.byteLength);
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  assert.ok(decoder.DecodeBufferToMesh(buffer, mesh).ok());
  const values = new draco.DracoFloat32Array();
  decoder.GetAttributeFloatForAllPoints(mesh, decoder.GetAttributeByUniqueId(mesh, attributes.POSITION), values);
  const positions = Array.from({ length: values.size() }, (_, i) => values.GetValue(i));
  const count = (name) => json.accessors[name === 'indices' ? primitive.indices : primitive.attributes[name]].count;
  assert.equal(count('POSITION'), mesh.num_points());
  assert.equal(count('indices'), 3 * mesh.num_faces());
  return { points: mesh.num_points(), triangles: mesh.num_faces(), positions };
}

test('mesh_is_the_same_surface_in_every_file', async (t) => {
  const files = ['--mesh-files', 'glb,draco.glb,ply,obj'];
  const { out, totals } = await exportRig(t, 'mesh', '--to', '0.1', '--voxel', '0.02', ...files);
  assert.deepEqual(readdirSync(out).sort(), ['room.draco.glb', 'room.glb', 'room.obj', 'room.ply']);
  const small = await validator.validateBytes(new Uint8Array(readFileSync(join(out, 'room.draco.glb'))));
  assert.equal(small.issues.numErrors, 0, JSON.stringify(small.issues.messages));
  assert.ok(statSync(join(out, 'room.draco.glb')).size < statSync(join(out, 'room.glb')).size / 8);
  assert.ok(totals.triangles > 1000);
  const report = await validator.validateBytes(new Uint8Array(readFileSync(join(out, 'room.glb'))));
  assert.equal(report.issues.numErrors, 0, JSON.stringify(report.issues.messages));
  assert.equal(report.info.totalTriangleCount, totals.triangles);
  const document = await new NodeIO().read(join(out, 'room.glb'));
  const primitive = document.getRoot().listMeshes()[0].listPrimitives()[0];
  assert.equal(primitive.getAttribute('COLOR_0').getCount(), totals.points);
  const ply = new PLYLoader().parse(arrayBuffer(join(out, 'room.ply')));
  assert.equal(ply.getIndex().count, 3 * totals.triangles);
  assert.deepEqual([...ply.getAttribute('position').array], [...primitive.getAttribute('POSITION').getArray()]);
  const obj = new OBJLoader().parse(readFileSync(join(out, 'room.obj'), 'utf8'));
  assert.equal(obj.children[0].geometry.getAttribute('position').count, 3 * totals.triangles);
  const draco = await readDraco(join(out, 'room.draco.glb'));
  assert.ok(Math.abs(draco.triangles / totals.triangles - 1) < 0.01 && Math.abs(draco.points / totals.points - 1) < 0.01);
  const middle = (values, axis) => values.reduce((sum, value, i) => (i % 3 === axis ? sum + value : sum), 0) / (values.length / 3);
  const exact = [...ply.getAttribute('position').array];
  for (const axis of [0, 1, 2]) assert.ok(Math.abs(middle(draco.positions, axis) - middle(exact, axis)) < 0.005);
  const truth = truePoints(0);
  const near = (x, y, z) => truth.some((p) => Math.hypot(p[0] - x, p[1] - y, p[2] - z) < 0.05);
  const points = ply.getAttribute('position');
  let compared = 0;
  let far = 0; // where the surfaces of two sensors cross, which no room has
  for (let i = 0; i < points.count; i += 97, ++compared) far += !near(points.getX(i), points.getY(i), points.getZ(i));
  assert.ok(far <= 0.03 * compared, `${far} of ${compared} points are elsewhere`);
});

/** All messages of an exported room.mcap, decoded by the schemas in the file: `{ topic, schema, type, content, logTime }`. */
async function readFoxglove(file) {
  const { reader, messages } = await readIndexed(file);
  return messages.map(({ topic, channelId, data, logTime }) => {
    const schema = reader.schemasById.get(reader.channelsById.get(channelId).schemaId);
    const type = createFileRegistry(fromBinary(FileDescriptorSetSchema, schema.data)).getMessage(schema.name);
    return { topic, schema: schema.name, type, content: fromBinary(type, data), logTime };
  });
}

/** Number and type of each field, by its name, as the published schema has them. */
function publishedFields(schemaName) {
  const schema = foxgloveMessageSchemas[schemaName.replace('foxglove.', '')];
  assert.ok(schema, `${schemaName} is no Foxglove schema`);
  const numbersOfTheirOwn = new Set(schema.fields.map(({ protobufFieldNumber }) => protobufFieldNumber));
  let next = 1;
  return new Map(
    schema.fields.map(({ name, protobufFieldNumber, type }) => {
      while (!protobufFieldNumber && numbersOfTheirOwn.has(next)) ++next;
      return [name, { number: protobufFieldNumber ?? next++, type: type.type === 'primitive' ? type.name : type.type }];
    }),
  );
}

const { ScalarType } = require('@bufbuild/protobuf');
const scalars = { uint32: ScalarType.FIXED32, float64: ScalarType.DOUBLE, string: ScalarType.STRING, bytes: ScalarType.BYTES };

test('foxglove_messages_have_the_published_schemas', async (t) => {
  const { out } = await exportRig(t, 'foxglove', '--to', '0.3');
  const types = new Map((await readFoxglove(join(out, 'room.mcap'))).map(({ schema, type }) => [schema, type]));
  const known = ['CameraCalibration', 'FrameTransform', 'PointCloud', 'RawImage'].map((name) => `foxglove.${name}`);
  assert.deepEqual([...types.keys()].sort(), known);
  // One file defines them all; these are not in a recording without colour.
  for (const name of ['foxglove.CompressedVideo', 'foxglove.CompressedImage', 'foxglove.FrameTransforms']) {
    types.set(name, types.get('foxglove.PointCloud').file.messages.find(({ typeName }) => typeName === name) ?? assert.fail(name));
  }
  for (const [schema, type] of types) {
    const published = publishedFields(schema);
    for (const { name, number, scalar } of type.fields) {
      const expected = published.get(name);
      assert.ok(expected, `${schema} has no field ${name}`);
      assert.equal(number, expected.number, `${schema}.${name}`);
      if (scalars[expected.type]) assert.equal(scalar, scalars[expected.type], `${schema}.${name}`);
    }
  }
});

for (const up of ['y', 'z']) {
  test(`foxglove_points_depth_and_poses_agree_with_${up}_up`, async (t) => {
    const { out } = await exportRig(t, 'foxglove', '--keep-doubles', '--to', '0.3', ...(up === 'y' ? ['--up', 'y'] : []));
    const messages = await readFoxglove(join(out, 'room.mcap'));
    const first = (topic) => messages.find((message) => message.topic === topic).content;
    const points = first('/points');
    assert.equal(points.frameId, 'world');
    const view = new DataView(points.data.buffer, points.data.byteOffset, points.data.byteLength);
    const positions = Array.from({ length: points.data.length / 16 }, (_, i) => [0, 4, 8].map((at) => view.getFloat32(16 * i + at, true)));
    const truth = truePoints(0).map(([x, y, z]) => (up === 'y' ? [x, y, z] : [x, -z, y]));
    assertSamePoints(positions.flat(), truth);
    // A depth picture, its calibration and its pose give the same points.
    const [depth, camera] = [first('/s1/depth'), first('/s1/camera')];
    const pose = messages.find(({ topic, content }) => topic === '/tf' && content.childFrameId === 's1').content;
    assert.deepEqual([depth.encoding, depth.width, depth.height, depth.step], ['16UC1', 64, 48, 128]);
    const pixels = new Uint16Array(depth.data.slice().buffer);
    for (const [x, y] of [[1, 1], [40, 20], [62, 46]]) {
      const z = pixels[64 * y + x] / 1000;
      assert.equal(pixels[64 * y + x], 1600 + x + y);
      const inDepth = [((x - camera.K[2]) / camera.K[0]) * z, ((y - camera.K[5]) / camera.K[4]) * z, z];
      const rotated = rotate(pose.rotation, inDepth);
      const place = [pose.translation.x, pose.translation.y, pose.translation.z].map((offset, axis) => rotated[axis] + offset);
      const expected = positions[62 * 46 + 62 * (y - 1) + x - 1];
      place.forEach((value, axis) => assert.ok(Math.abs(value - expected[axis]) < 1e-4, `pixel ${x}, ${y}: ${place}, not ${expected}`));
    }
  });
}

/** The quaternion's rotation of a point: p + 2 q x (q x p + w p). */
function rotate({ x, y, z, w }, p) {
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const inner = cross([x, y, z], p).map((value, axis) => value + w * p[axis]);
  return cross([x, y, z], inner).map((value, axis) => p[axis] + 2 * value);
}

test('the_axis_that_points_up_is_chosen_for_foxglove_alone', async (t) => {
  const out = join(scratchFolder(t), 'out');
  assertFailed(await run('export', rig, '--format', 'ply', '--out', out, '--up', 'z'), 2, /--up is an option of --format foxglove/);
  assertFailed(await run('export', rig, '--format', 'foxglove', '--out', out, '--up', 'x'), 2, /--help/);
  assert.ok(!existsSync(out));
});

test('a_rig_that_was_exported_is_the_same_recording', async (t) => {
  const { out } = await exportRig(t, 'tum');
  const [before_, after_] = [await run('info', rig, '--json'), await run('info', out, '--json')];
  const crcs = ({ stdout }) => JSON.parse(stdout).sensors.map(({ depth_crc32 }) => depth_crc32);
  assert.deepEqual(crcs(after_), crcs(before_));
  const lines = readFileSync(join(out, 's1', 'groundtruth.txt'), 'utf8').trim().split('\n');
  const [, x, y, z] = lines[0].split(' ').map(Number);
  const pose = JSON.parse(readFileSync(join(rig, 'rig.json'), 'utf8')).sensors[1].world_from_depth;
  assert.deepEqual([x, y, z], [pose[3], pose[7], pose[11]]);
  const single = await run('info', join(out, 's1'), '--json');
  assert.equal(single.code, 0, single.stderr);
});

/** All files below a folder: path to bytes. */
function filesOf(folder, below = '') {
  return readdirSync(join(folder, below), { withFileTypes: true }).flatMap((entry) => {
    const path = join(below, entry.name);
    return entry.isDirectory() ? filesOf(folder, path) : [[path, readFileSync(join(folder, path))]];
  });
}

for (const format of ['rig', 'tum']) {
  test(`${format}_exported_again_is_the_same_byte_for_byte`, async (t) => {
    const { out } = await exportRig(t, format);
    const again = join(scratchFolder(t), 'out');
    const result = await run('export', out, '--format', format, '--out', again);
    assert.equal(result.code, 0, result.stderr);
    const [first, second] = [new Map(filesOf(out)), new Map(filesOf(again))];
    assert.deepEqual([...second.keys()].sort(), [...first.keys()].sort());
    for (const [path, bytes] of first) assert.ok(bytes.equals(second.get(path)), path);
  });
}

test('foxglove_imported_and_exported_again_is_the_same', async (t) => {
  const { out } = await exportRig(t, 'foxglove');
  const [imported, again] = [join(scratchFolder(t), 'rig'), join(scratchFolder(t), 'out')];
  const importing = await run('import', join(out, 'room.mcap'), imported, '--json');
  assert.equal(importing.code, 0, importing.stderr);
  assert.equal(importing.stderr, '');
  const crcs = ({ stdout }) => JSON.parse(stdout).sensors.map(({ id, depth_crc32 }) => [id, depth_crc32]);
  assert.deepEqual(crcs(await run('info', imported, '--json')), crcs(await run('info', rig, '--json')));
  const exporting = await run('export', imported, '--format', 'foxglove', '--out', again);
  assert.equal(exporting.code, 0, exporting.stderr);
  const told = async (folder) => (await readFoxglove(join(folder, 'room.mcap'))).map(({ topic, content, logTime }) => [topic, logTime, content]);
  const [first, second] = [await told(out), await told(again)];
  assert.equal(second.length, first.length);
  first.forEach(([topic, time, content], i) => {
    assert.deepEqual(second[i].slice(0, 2), [topic, time]);
    if (topic !== '/tf') return assert.deepEqual(second[i][2], content, topic);
    // A quaternion and its negative are the same rotation.
    const [p, q] = [content, second[i][2]].map(({ rotation }) => ['x', 'y', 'z', 'w'].map((axis) => rotation[axis]));
    const sign = Math.sign(p.reduce((sum, value, axis) => sum + value * q[axis], 0));
    p.forEach((value, axis) => assert.ok(Math.abs(value - sign * q[axis]) < 1e-12, `${p} became ${q}`));
    return assert.deepEqual(second[i][2].translation, content.translation);
  });
});

test('a_foxglove_file_is_played_and_a_damaged_one_refused_with_one_sentence', async (t) => {
  const { out } = await exportRig(t, 'foxglove');
  const file = join(out, 'room.mcap');
  const specs = [0, 1].flatMap((n) => ['--source', `foxglove:${file}#s${n}`]);
  const demo = await run('demo', '--headless', '--seconds', '3', '--port', '0', ...specs);
  assert.equal(demo.code, 0, demo.stderr);
  assert.match(demo.stdout, /received 2 of 2 sensors/);
  const bytes = readFileSync(file);
  const bad = { empty: Buffer.alloc(0), short: bytes.subarray(0, 200), text: Buffer.from('no recording'), noise: Buffer.concat([bytes.subarray(0, 8), Buffer.alloc(3000, 0xff)]) };
  for (const [name, content] of Object.entries(bad)) {
    const path = join(out, `${name}.mcap`);
    writeFileSync(path, content);
    assertFailed(await run('import', path, join(out, 'rig')), 1, new RegExp(`${name}\\.mcap`));
    assertFailed(await run('sensor', '--source', `foxglove:${path}`, '--hub', 'ws://127.0.0.1:9'), 1, new RegExp(`${name}\\.mcap`));
  }
  writeFileSync(join(out, 'cut.mcap'), bytes.subarray(0, Math.floor(bytes.length * 0.6)));
  const cut = await run('import', join(out, 'cut.mcap'), join(out, 'rig'), '--json');
  assert.equal(cut.code, 0, cut.stderr);
  assert.match(cut.stderr, /everything before that was read/);
  const frames = JSON.parse(cut.stdout).sensors[0].frames;
  assert.ok(frames > 2 && frames < 10, String(frames));
});

test('an_export_goes_on_where_it_was_interrupted', async (t) => {
  const { out } = await exportRig(t, 'ply', '--every', '3');
  const kept = statSync(join(out, 'set_000003.ply')).mtimeMs;
  const again = await run('export', rig, '--format', 'ply', '--out', out, '--json');
  const totals = JSON.parse(again.stdout);
  assert.deepEqual([totals.kept, totals.sets], [4, 6]);
  assert.equal(statSync(join(out, 'set_000003.ply')).mtimeMs, kept);
});

test('doubles_are_left_out_and_clouds_are_cropped_and_thinned', async (t) => {
  const points = async (...options) => (await exportRig(t, 'ply', '--to', '0.1', ...options)).totals.points;
  const all = await points('--keep-doubles');
  const merged = await points();
  assert.ok(merged <= all);
  const cropped = await points('--crop=-0.2,0,-0.2,0.2,3,0.2');
  assert.ok(cropped < merged);
  assert.ok((await points('--voxel', '0.1')) < merged / 2);
});

test('refusals_state_the_reason', async (t) => {
  const out = join(scratchFolder(t), 'out');
  const at = ['--format', 'ply', '--out', out];
  assertFailed(await run('export', '/no/such/recording', ...at), 1, /cannot open/);
  assertFailed(await run('export', rig, ...at, '--from', '100'), 1, /has no frames/);
  assertFailed(await run('export', rig, ...at, '--crop=0,0,0,0,0'), 2, /--help/);
  const mesh = ['--format', 'mesh', '--out', out];
  assertFailed(await run('export', rig, ...mesh, '--voxel', '0.0001'), 2, /--voxel of a mesh is 0\.002 to 0\.2/);
  assertFailed(await run('export', rig, ...mesh, '--mesh-files', 'stl'), 2, /--help/);
  assertFailed(await run('export', rig, ...mesh, '--crop=50,50,50,60,60,60'), 1, /no surface that stands still/);
  assert.ok(!existsSync(join(out, 'room.glb')));
  mkdirSync(join(out, 'full'), { recursive: true });
  assertFailed(await run('export', rig, '--format', 'rig', '--out', out), 1, /not empty/);
  assert.ok(existsSync(out));
});

/** A path from the pose of the first sensor to half a metre right of it; the point 2 m ahead stays in the middle. */
function writeWalk(folder) {
  const file = join(folder, 'walk.json');
  const m = JSON.parse(readFileSync(join(rig, 'rig.json'), 'utf8')).sensors[0].world_from_depth;
  const place = (x, z) => [0, 1, 2].map((row) => m[4 * row] * x + m[4 * row + 2] * z + m[4 * row + 3]);
  const keys = [{ time_s: 0, at: place(0, 0), look: place(0, 2) }, { time_s: 1.8, at: place(0.5, 0), look: place(0, 2) }];
  writeFileSync(file, JSON.stringify({ keys }));
  return file;
}

const film = ['--format', 'video', '--size', '64,48', '--fps', '10', '--mode', 'mesh', '--json'];

test('video_is_a_folder_of_pictures_where_there_is_no_ffmpeg', async (t) => {
  const folder = scratchFolder(t);
  const out = join(folder, 'out');
  const program = new Program(['export', rig, ...film, '--out', out, '--path', writeWalk(folder)], {
    through: ['/usr/bin/env', 'PATH=/nowhere'],
  });
  assert.equal(await program.ended, 0, program.stderr);
  const pictures = readdirSync(join(out, 'film')).sort();
  assert.equal(pictures.length, 19, '1.8 s at 10 a second, and the last set');
  assert.equal(JSON.parse(program.stdout).pictures, 19);
  const [first, last] = [pictures[0], pictures.at(-1)].map((name) => readFileSync(join(out, 'film', name)));
  assert.deepEqual([first.readUInt32BE(16), first.readUInt32BE(20)], [64, 48]);
  assert.notDeepEqual(first, last, 'the camera has moved');
});

const noFfmpeg = spawnSync('ffprobe', ['-version']).error ? 'ffmpeg is not installed' : false;

test('video_has_the_requested_length_and_size', { skip: noFfmpeg }, async (t) => {
  const folder = scratchFolder(t);
  const out = join(folder, 'out');
  const result = await run('export', rig, ...film, '--out', out);
  assert.equal(result.code, 0, result.stderr);
  assert.deepEqual(readdirSync(out), ['film.mp4'], 'nothing half done is left');
  const probe = ['-v', 'error', '-count_frames', '-show_entries', 'stream=nb_read_frames,width,height,r_frame_rate', '-of', 'json'];
  const { streams } = JSON.parse(execFileSync('ffprobe', [...probe, join(out, 'film.mp4')], { encoding: 'utf8' }));
  assert.deepEqual(streams, [{ width: 64, height: 48, r_frame_rate: '10/1', nb_read_frames: '19' }]);
  assertFailed(await run('export', rig, ...film, '--out', out), 1, /film\.mp4 already/);
});

test('an_invalid_camera_path_is_named', async (t) => {
  const folder = scratchFolder(t);
  const path = join(folder, 'walk.json');
  writeFileSync(path, '{"keys": [{"time_s": 0, "at": [0, 0, 0], "look": [0, 0, 0]}]}');
  const result = await run('export', rig, ...film, '--out', join(folder, 'out'), '--path', path);
  assertFailed(result, 2, /walk\.json.*key 0.*must look at another place/);
});
