// SPDX-License-Identifier: Apache-2.0
// The pointing ray of the user's own hand or another viewer's hand.
import * as THREE from 'three';

/** A line along -z that fades out. */
export function pointerRay(length_m: number, rgb: number): THREE.Line {
  const bright = new THREE.Color(rgb);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute([0, 0, 0, 0, 0, -length_m], 3));
  geometry.setAttribute(
    'color',
    new THREE.Float32BufferAttribute([...bright.toArray(), 0.8, ...bright.toArray(), 0], 4),
  );
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({ vertexColors: true, transparent: true }));
}
