// SPDX-License-Identifier: Apache-2.0
// A viewer's laser pointer: a rod of light from the hand to the target, where a spot has the viewer's name.
import * as THREE from 'three';

const radius_m = 0.003;
const spotRadius_m = 0.014;
const labelAbove_m = -0.18; // a label stands 27 cm above what it names

/** As in control.proto. */
export interface BeamEnds {
  from?: { x: number; y: number; z: number } | undefined;
  to?: { x: number; y: number; z: number } | undefined;
}

/** A rod along +z, one metre long, with a spot at its end, and beside that the label if there is one. */
export function beamOf(color: number, label?: THREE.Sprite): THREE.Group {
  const light = new THREE.MeshBasicMaterial({ color });
  const rod = new THREE.Mesh(new THREE.CylinderGeometry(radius_m, radius_m, 1, 8, 1, true), light);
  rod.rotation.x = Math.PI / 2;
  rod.position.z = 0.5;
  const spot = new THREE.Mesh(new THREE.SphereGeometry(spotRadius_m, 12, 8), light);
  spot.position.z = 1;
  if (label) {
    label.position.y += labelAbove_m;
    spot.add(label);
  }
  const beam = new THREE.Group();
  beam.add(rod, spot);
  beam.visible = false;
  return beam;
}

/** Beams are not interpolated, because pointing movements are quick. */
export function shine(group: THREE.Group, beam: BeamEnds | undefined): void {
  group.visible = beam?.from !== undefined && beam.to !== undefined;
  if (!beam?.from || !beam.to) return;
  const to = new THREE.Vector3(beam.to.x, beam.to.y, beam.to.z);
  group.position.set(beam.from.x, beam.from.y, beam.from.z);
  const length = Math.max(1e-3, group.position.distanceTo(to));
  group.lookAt(to);
  group.scale.set(1, 1, length);
  group.children[1]!.scale.set(1, 1, 1 / length); // the spot stays round
}
