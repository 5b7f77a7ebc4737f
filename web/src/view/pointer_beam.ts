// SPDX-License-Identifier: Apache-2.0
// A viewer's laser pointer: a rod of light from the hand to the target.
import * as THREE from 'three';
import type { Beam } from '../gen/control_pb';

const radius_m = 0.003;
const spotRadius_m = 0.014;

/** A rod along +z, one metre long, with a spot at its end. */
export function beamOf(color: number): THREE.Group {
  const light = new THREE.MeshBasicMaterial({ color });
  const rod = new THREE.Mesh(new THREE.CylinderGeometry(radius_m, radius_m, 1, 8, 1, true), light);
  rod.rotation.x = Math.PI / 2;
  rod.position.z = 0.5;
  const spot = new THREE.Mesh(new THREE.SphereGeometry(spotRadius_m, 12, 8), light);
  spot.position.z = 1;
  const beam = new THREE.Group();
  beam.add(rod, spot);
  beam.visible = false;
  return beam;
}

/** Beams are not interpolated, because pointing movements are quick. */
export function shine(group: THREE.Group, beam: Beam | undefined): void {
  group.visible = beam?.from !== undefined && beam.to !== undefined;
  if (!beam?.from || !beam.to) return;
  const to = new THREE.Vector3(beam.to.x, beam.to.y, beam.to.z);
  group.position.set(beam.from.x, beam.from.y, beam.from.z);
  const length = Math.max(1e-3, group.position.distanceTo(to));
  group.lookAt(to);
  group.scale.set(1, 1, length);
  group.children[1]!.scale.set(1, 1, 1 / length); // the spot stays round
}
