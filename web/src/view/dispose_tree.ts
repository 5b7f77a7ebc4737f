// SPDX-License-Identifier: Apache-2.0
// Gives back what a drawn object and all below it hold on the graphics processor.
import * as THREE from 'three';

export function disposeTree(root: THREE.Object3D): void {
  root.traverse((object) => {
    if (!(object instanceof THREE.Mesh || object instanceof THREE.Sprite || object instanceof THREE.Line)) return;
    const material = object.material as THREE.MeshBasicMaterial;
    material.map?.dispose();
    material.dispose();
    if (!(object instanceof THREE.Sprite)) object.geometry.dispose();
  });
}
