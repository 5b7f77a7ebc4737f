// SPDX-License-Identifier: Apache-2.0
// A recording of two sensors in a simulated living room that nothing but a person can put together: one knows its place,
// the other does not, and their colour cameras are so far out of focus that no feature is found in their pictures.
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { run } from './programs.mjs';

function putOutOfFocus(picture) {
  const sharp = readFileSync(picture);
  const options = ['-v', 'error', '-y', '-i', 'pipe:0', '-vf', 'gblur=sigma=120', picture];
  execFileSync('ffmpeg', options, { input: sharp });
}

/** Writes it to `rig`; returns where s1 stands: world_from_depth. */
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
