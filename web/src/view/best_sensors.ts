// SPDX-License-Identifier: Apache-2.0
// Chooses the sensors to draw when the machine cannot draw all of them: those with the viewing direction most similar
// to the viewer's (the ranking of Buehler et al. 2001, by the angle at the viewed point), nearer ones first. Pure.
import { Matrix4, Vector3 } from 'three';

const typicalDepth_m = 2.2; // assumed distance from a sensor to the room's middle
const farther_perM = 0.05; // penalty per metre between eye and sensor

/** How well the sensor shows the surfaces seen from `eye`; higher is better. */
export function usefulness(worldFromDepth: Matrix4, eye: Vector3): number {
  const position = new Vector3().setFromMatrixPosition(worldFromDepth);
  const gaze = new Vector3().setFromMatrixColumn(worldFromDepth, 2);
  const target = gaze.clone().multiplyScalar(typicalDepth_m).add(position);
  const seenFromEye = target.sub(eye).normalize();
  return seenFromEye.dot(gaze) - farther_perM * position.distanceTo(eye);
}

/** Ids of the `most` most useful sensors. */
export function bestSensors(sensors: ReadonlyMap<number, Matrix4>, eye: Vector3, most: number): Set<number> {
  const ranked = [...sensors]
    .map(([id, worldFromDepth]) => ({ id, use: usefulness(worldFromDepth, eye) }))
    .sort((a, b) => b.use - a.use || a.id - b.id);
  return new Set(ranked.slice(0, most).map(({ id }) => id));
}
