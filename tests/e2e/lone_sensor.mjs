// SPDX-License-Identifier: Apache-2.0
// A recording of two sensors in a simulated living room that only a person can align: one sensor's pose is known, the
// other's is not, and both colour cameras are so far out of focus that no feature is found in their pictures.
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { run } from './programs.mjs';

function putOutOfFocus(picture) {
  const sharp = readFileSync(picture);
  const options = ['-v', 'error', '-y', '-i', 'pipe:0', '-vf', 'gblur=sigma=120', picture];
  execFileSync('ffmpeg', options, { input: sharp });
}

/** Writes the recording to `rig`; returns the pose of s1: world_from_depth. */
export async function writeLoneSensor(rig) {
  const room = ['--scene', 'livingroom', '--sensors', '2', '--speed', '0', '--half-color'];
  await run('simulate', rig, ...room, '--seconds', '1.5', '--fps', '4');
  const description = JSON.parse(readFileSync(join(rig, 'rig.json'), 'utf8'));
  const lone = description.sensors[1];
  const truth = lone.world_from_depth;
  lone.world_from_depth = null;
  writeFileSync(join(rig, 'rig.json'), JSON.stringify(description));
  for (const { id, path = id } of description.sensors) {
    const folder = join(rig, path, 'rgb');
    for (const name of readdirSync(folder)) putOutOfFocus(join(folder, name));
  }
  return truth;
}
