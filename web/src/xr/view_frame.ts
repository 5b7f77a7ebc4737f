// SPDX-License-Identifier: Apache-2.0
// The dark frame that narrows the view in a headset: a disc before the eyes that is clear in the middle. World
// coordinates, metres.
import * as THREE from 'three';

const ahead_m = 0.5;
const radius_m = 2; // 76 degrees to each side: more than headsets show
const clear_share = 0.14; // of the radius: 29 degrees
const dark_share = 0.3; // 50 degrees
const size_px = 512;

function picture(): THREE.CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = size_px;
  const paint = canvas.getContext('2d')!;
  const half = size_px / 2;
  const shades = paint.createRadialGradient(half, half, 0, half, half, half);
  shades.addColorStop(clear_share, 'rgba(0, 0, 0, 0)');
  shades.addColorStop(dark_share, 'rgba(0, 0, 0, 1)');
  paint.fillStyle = shades;
  paint.fillRect(0, 0, size_px, size_px);
  return new THREE.CanvasTexture(canvas);
}

export class ViewFrame {
  readonly root: THREE.Mesh<THREE.CircleGeometry, THREE.MeshBasicMaterial>;

  constructor() {
    const material = new THREE.MeshBasicMaterial({ transparent: true, depthTest: false, depthWrite: false });
    this.root = new THREE.Mesh(new THREE.CircleGeometry(radius_m, 48), material);
    this.root.renderOrder = 9; // before the board, which stays readable
    this.root.frustumCulled = false;
    this.root.visible = false;
  }

  /** `narrow`: 0, nothing is hidden, to 1. */
  show(narrow: number, { position: p, orientation: o }: XRRigidTransform): void {
    this.root.visible = narrow > 0;
    if (narrow === 0) return;
    const { material } = this.root;
    if (!material.map) {
      material.map = picture(); // not before somebody walks
      material.needsUpdate = true;
    }
    material.opacity = narrow;
    this.root.quaternion.set(o.x, o.y, o.z, o.w);
    this.root.position.set(0, 0, -ahead_m).applyQuaternion(this.root.quaternion).add(new THREE.Vector3(p.x, p.y, p.z));
  }

  hide(): void {
    this.root.visible = false;
  }
}
