// SPDX-License-Identifier: Apache-2.0
// `roomcast ros2` and `--source ros2-topic:` against another DDS implementation (Fast DDS, tests/ros2_peer.cpp), on this computer only.
// No node of ROS 2 itself is run.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync, readdirSync, readlinkSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';

import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, assertFailed, binary, run, scratchFolder, startHub } from './program.mjs';

const peerBinary = join(dirname(binary), 'roomcast_ros2_peer');
const noPeer = existsSync(peerBinary) ? false : `${peerBinary} is not built: cyclonedds-dev or libfastrtps-dev is not installed`;

// Ports of these domains are below those that the system gives out.
let domain = 20 + (process.pid % 70);
const nextDomain = () => String(++domain);

async function startSmallRoom(t, ...sensors) {
  const hub = await startHub(t);
  const rig = writeSmallRig(scratchFolder(t));
  for (const sensor of sensors) {
    const program = new Program(['sensor', '--source', `rig:${rig}#${sensor}`, '--hub', hub.url, '--codec', 'lossless', '--always', '--verbose']);
    t.after(() => program.stop('SIGKILL'));
    await program.prints(/joined/);
  }
  return hub;
}

/** Starts the bridge; resolves when it has told `topics` topics. */
async function startBridge(t, hub, inDomain, topics, ...options) {
  const program = new Program(['ros2', '--hub', hub.url, '--domain', inDomain, '--json', ...options]);
  t.after(() => program.stop('SIGKILL'));
  for (;;) {
    const lines = program.stdout.split('\n').filter(Boolean).map((line) => JSON.parse(line));
    if (lines.at(-1)?.topics.length === topics) return { program, topics: lines.at(-1).topics };
    await program.prints(new RegExp(`(.*\n){${lines.length + 1}}`));
  }
}

/** What Fast DDS reads: the first `count` messages of each topic, "NAME=TYPE". */
async function readByFastDds(t, inDomain, count, quality, ...topics) {
  const child = spawn(peerBinary, ['read', inDomain, String(count), quality, ...topics], { stdio: ['ignore', 'pipe', 'inherit'] });
  t.after(() => child.kill('SIGKILL'));
  let text = '';
  child.stdout.setEncoding('utf8').on('data', (more) => (text += more));
  const [code] = await once(child, 'close');
  const messages = text.split('\n').filter(Boolean).map((line) => JSON.parse(line));
  assert.equal(code, 0, `not all came: ${messages.map(({ topic }) => topic)}`);
  return (name) => messages.filter(({ topic }) => topic === name);
}

const floats = (hex) => new Float32Array(Uint8Array.from(Buffer.from(hex, 'hex')).buffer);

test('another_implementation_reads_pictures_cameras_points_and_poses', { skip: noPeer }, async (t) => {
  const inDomain = nextDomain();
  const hub = await startSmallRoom(t, 's0', 's1');
  const bridge = await startBridge(t, hub, inDomain, 12);
  assert.deepEqual(
    bridge.topics.filter((topic) => !topic.includes('/s1/')),
    ['/roomcast/points', '/roomcast/s0/color/camera_info', '/roomcast/s0/color/image_raw', '/roomcast/s0/depth/camera_info', '/roomcast/s0/depth/image_raw', '/roomcast/s0/points', '/tf_static'],
  );
  const of = await readByFastDds(t, inDomain, 3, 'sensor_data', '/roomcast/s0/depth/image_raw=Image', '/roomcast/s0/depth/camera_info=CameraInfo', '/roomcast/s0/points=PointCloud2', '/roomcast/points=PointCloud2');

  // The rig's depth is a plane that moves by 10 mm a frame: bit for bit.
  for (const depth of of('/roomcast/s0/depth/image_raw')) {
    assert.deepEqual([depth.encoding, depth.width, depth.height, depth.step, depth.is_bigendian, depth.header.frame_id], ['16UC1', 64, 48, 128, 0, 's0_optical_frame']);
    const pixels = new Uint16Array(Uint8Array.from(Buffer.from(depth.data, 'hex')).buffer);
    assert.equal(pixels.length, 64 * 48);
    assert.ok(pixels[0] >= 1500 && pixels[0] < 1700 && pixels[0] % 10 === 0, `${pixels[0]}`);
    for (let i = 0; i < pixels.length; ++i) assert.equal(pixels[i], pixels[0] + (i % 64) + Math.floor(i / 64));
    assert.ok(Math.abs(depth.header.sec - Date.now() / 1000) < 30, 'capture times are those of day');
  }
  const [camera] = of('/roomcast/s0/depth/camera_info');
  assert.deepEqual([camera.width, camera.height, camera.distortion_model, camera.binning, camera.roi], [64, 48, 'plumb_bob', [0, 0], [0, 0, 0, 0, false]]);
  assert.deepEqual(camera.k, [60, 0, 31.5, 0, 60, 23.5, 0, 0, 1]);
  assert.deepEqual(camera.p, [60, 0, 31.5, 0, 0, 60, 23.5, 0, 0, 0, 1, 0]);

  // Points are those of the depth picture and the camera, to a tenth of a millimetre.
  const [cloud] = of('/roomcast/s0/points');
  assert.deepEqual(cloud.fields, [['x', 0, 7, 1], ['y', 4, 7, 1], ['z', 8, 7, 1], ['rgb', 12, 7, 1]]);
  assert.deepEqual([cloud.width, cloud.height, cloud.point_step, cloud.row_step], [64, 48, 16, 1024]);
  const points = floats(cloud.data);
  const nearest = points[2];
  for (let i = 0; i < 64 * 48; ++i) {
    const [column, row] = [i % 64, Math.floor(i / 64)];
    const z = nearest + (column + row) / 1000;
    for (const [value, expected] of [[points[4 * i], ((column - 31.5) / 60) * z], [points[4 * i + 1], ((row - 23.5) / 60) * z], [points[4 * i + 2], z]])
      assert.ok(Math.abs(value - expected) < 1e-4, `${i}: ${value}, not ${expected}`);
  }
  const [merged] = of('/roomcast/points');
  assert.equal(merged.header.frame_id, 'world');
  assert.ok(merged.width > 1000 && merged.is_dense, `${merged.width}`);
  // Both cameras look across the room from 1.5 m above the floor; z is up.
  const heights = floats(merged.data).filter((_, i) => i % 4 === 2);
  assert.ok(heights.every((z) => z > 0 && z < 3), `${Math.min(...heights)} ${Math.max(...heights)}`);

  // A reader that comes later still gets the poses.
  const late = await readByFastDds(t, inDomain, 1, 'sensor_data', '/tf_static=TFMessage');
  const pose = late('/tf_static')[0].transforms.find(({ child_frame_id: child }) => child === 's0_optical_frame');
  assert.equal(pose.header.frame_id, 'world');
  for (const [value, expected] of pose.translation.map((value, i) => [value, [0, -2, 1.5][i]])) assert.ok(Math.abs(value - expected) < 1e-9, `${pose.translation}`);
  assert.equal(await bridge.program.stop(), 0);
});

test('who_wants_reliable_pictures_gets_them_with_an_option', { skip: noPeer }, async (t) => {
  const inDomain = nextDomain();
  const hub = await startSmallRoom(t, 's0');
  await startBridge(t, hub, inDomain, 7, '--reliable', '--prefix', '/lab/two');
  const of = await readByFastDds(t, inDomain, 5, 'reliable', '/lab/two/s0/depth/image_raw=Image');
  assert.equal(of('/lab/two/s0/depth/image_raw').length, 5);
});

test('a_camera_of_another_implementation_comes_into_a_room', { skip: noPeer }, async (t) => {
  const inDomain = nextDomain();
  const hub = await startHub(t);
  const child = spawn(peerBinary, ['camera', inDomain], { stdio: ['ignore', 'pipe', 'inherit'] });
  t.after(() => child.kill('SIGKILL'));
  await once(child.stdout, 'data');
  const environment = { ROS_DOMAIN_ID: inDomain, ROS_LOCALHOST_ONLY: '1' };
  const source = 'ros2-topic:/peer/depth/image_raw,/peer/color/image_raw';
  const sensor = new Program(['sensor', '--source', source, '--hub', hub.url, '--codec', 'lossless', '--always', '--keep-holes', '--keep-interference'], { environment });
  t.after(() => sensor.stop('SIGKILL'));
  assert.equal((await sensor.prints(/joined as "(.*)"/))[1], 'peer');
  // Round trip: the room's depth, published as ROS 2, is the camera's.
  const back = nextDomain();
  await startBridge(t, hub, back, 7);
  const of = await readByFastDds(t, back, 2, 'sensor_data', '/roomcast/peer/depth/image_raw=Image', '/roomcast/peer/color/image_raw=Image', '/roomcast/peer/depth/camera_info=CameraInfo');
  const [depth] = of('/roomcast/peer/depth/image_raw');
  assert.deepEqual([depth.width, depth.height], [32, 24]);
  const pixels = new Uint16Array(Uint8Array.from(Buffer.from(depth.data, 'hex')).buffer);
  for (let i = 0; i < pixels.length; ++i) assert.equal(pixels[i], 1000 + (i % 32) + 10 * Math.floor(i / 32));
  assert.deepEqual(of('/roomcast/peer/depth/camera_info')[0].k, [30, 0, 15.5, 0, 30, 11.5, 0, 0, 1]);
  const rgb = Buffer.from(of('/roomcast/peer/color/image_raw')[0].data, 'hex');
  const middle = 3 * (12 * 32 + 16);
  for (const [i, expected] of [200, 100, 50].entries()) assert.ok(Math.abs(rgb[middle + i] - expected) < 12, `${[...rgb.subarray(middle, middle + 3)]}`);
  // The camera's end is a loss, not the sensor's end.
  child.kill('SIGKILL');
  await sensor.prints(/the camera is lost: it has stopped sending pictures/);
  assert.equal(await sensor.stop(), 0);
});

test('a_topic_that_never_comes_is_a_sentence_and_an_interrupt_ends_the_waiting', { skip: noPeer }, async (t) => {
  const hub = await startHub(t);
  const environment = { ROS_DOMAIN_ID: nextDomain(), ROS_LOCALHOST_ONLY: '1' };
  const command = ['sensor', '--source', 'ros2-topic:/nobody/depth/image_raw', '--hub', hub.url];
  assertFailed(await run(...command, { environment }), 1, /nothing came on \/nobody\/depth\/camera_info; does the camera's node run, in ROS_DOMAIN_ID \d+ on this computer\?/);
  const waiting = new Program(command, { environment });
  await new Promise((resolved) => setTimeout(resolved, 1000));
  const begin = Date.now();
  assert.equal(await waiting.stop(), 0);
  assert.ok(Date.now() - begin < 2000);
});

test('wrong_names_and_domains_are_wrong_usage', { skip: noPeer }, async (t) => {
  const hub = await startHub(t);
  for (const [options, sentence] of [
    [['--prefix', 'lab'], /"lab\/points" is not the name of a ROS 2 topic/],
    [['--domain', '233'], /not a number from 0 to 232/],
  ])
    assertFailed(await run('ros2', '--hub', hub.url, ...options), 2, sentence);
  assertFailed(await run('ros2', '--hub', hub.url, { environment: { ROS_DOMAIN_ID: 'lab' } }), 2, /ROS_DOMAIN_ID is "lab"/);
  assertFailed(await run('sensor', '--hub', hub.url, '--source', 'ros2-topic:camera'), 2, /"camera" is not the name of a ROS 2 topic/);
});

test('only_this_computer_takes_part_unless_it_is_told_otherwise', { skip: noPeer }, async (t) => {
  const hub = await startHub(t);
  const inDomain = nextDomain();
  const { program } = await startBridge(t, hub, inDomain, 2);
  // Sockets of UDP, by the kernel: "local_address" is hexadecimal; 0100007F is 127.0.0.1.
  const inodes = new Set(readdirSync(`/proc/${program.child.pid}/fd`).map((fd) => {
    try { return readlinkSync(`/proc/${program.child.pid}/fd/${fd}`).match(/^socket:\[(\d+)\]/)?.[1]; } catch { return undefined; }
  }));
  const sockets = readFileSync('/proc/net/udp', 'utf8').split('\n').slice(1).map((line) => line.trim().split(/\s+/)).filter((row) => row.length > 9 && inodes.has(row[9]));
  // What receives has the domain's ports (DDSI-RTPS 2.3, 9.6.1.1). What sends is bound to 127.0.0.1, from which nothing is routed elsewhere.
  const begin = 7400 + 250 * Number(inDomain);
  const sends = sockets.filter((row) => {
    const port = parseInt(row[1].split(':')[1], 16);
    return port < begin || port >= begin + 250;
  });
  assert.ok(sends.length > 0, JSON.stringify(sockets));
  for (const row of sends) assert.match(row[1], /^0100007F:/);
});
