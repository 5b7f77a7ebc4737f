// SPDX-License-Identifier: Apache-2.0
// Draws the arc with which the wearer points at the floor, and the place where it ends.
import * as THREE from 'three';

const arcColor = 0x56b4e9;

export class ArcView {
  readonly root = new THREE.Group();
  private readonly line = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: arcColor }));
  private readonly ring = new THREE.Mesh(
    new THREE.RingGeometry(0.18, 0.24, 40).rotateX(-Math.PI / 2),
    new THREE.MeshBasicMaterial({ color: arcColor, transparent: true, opacity: 0.85, depthTest: false }),
  );

  constructor() {
    this.line.frustumCulled = false;
    this.root.add(this.line, this.ring);
    this.root.visible = false;
  }

  show(arc: readonly THREE.Vector3[]): void {
    this.line.geometry.setFromPoints([...arc]);
    this.ring.position.copy(arc.at(-1)!).setY(0.01);
    this.root.visible = true;
  }

  hide(): void {
    this.root.visible = false;
  }
}
