// SPDX-License-Identifier: Apache-2.0
// Which sensors to draw when the machine cannot draw all of them: those that look at the room most as the viewer does
// (the ranking of Buehler et al. 2001, by the angle at what is looked at), the nearer ones before the farther ones.
// Pure.
import { Matrix4, Vector3 } from 'three';

const typicalDepth_m = 2.2; // how far in front of a sensor the room's middle is taken to be
const farther_perM = 0.05; // what a metre between eye and sensor costs

/** How well the sensor shows what is seen from `eye`; more is better. */
export function usefulness(worldFromDepth: Matrix4, eye: Vector3): number {
  const position = new Vector3().setFromMatrixPosition(worldFromDepth);
  const gaze = new Vector3().setFromMatrixColumn(worldFromDepth, 2);
  const target = gaze.clone().multiplyScalar(typicalDepth_m).add(position);
  const seenFromEye = target.sub(eye).normalize();
  return seenFromEye.dot(gaze) - farther_perM * position.distanceTo(eye);
}

/** Ids of the `most` most useful ones. */
export function bestSensors(sensors: ReadonlyMap<number, Matrix4>, eye: Vector3, most: number): Set<number> {
  const ranked = [...sensors]
    .map(([id, worldFromDepth]) => ({ id, use: usefulness(worldFromDepth, eye) }))
    .sort((a, b) => b.use - a.use || a.id - b.id);
  return new Set(ranked.slice(0, most).map(({ id }) => id));
}
