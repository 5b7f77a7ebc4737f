// SPDX-License-Identifier: Apache-2.0
// Draws the wearer's own hands: a controller as a small sphere with a ray, a tracked hand as its joints. World
// coordinates.
import * as THREE from 'three';
import { pointerRay } from '../view/pointer_ray';

const color = 0xf2f5f8;
const jointCount = 25;
const ray_m = 0.5;

export class HandView {
  readonly root = new THREE.Group();
  private readonly controller = new THREE.Group();
  private readonly joints: THREE.InstancedMesh;

  constructor() {
    const material = new THREE.MeshLambertMaterial({ color });
    const grip = new THREE.Mesh(new THREE.SphereGeometry(0.03, 16, 12), material);
    this.controller.add(grip, pointerRay(ray_m, color));
    this.joints = new THREE.InstancedMesh(new THREE.SphereGeometry(1, 10, 8), material, jointCount);
    this.joints.frustumCulled = false;
    this.root.add(this.controller, this.joints);
    this.hide();
  }

  get shows(): 'nothing' | 'controller' | 'joints' {
    if (this.joints.visible) return 'joints';
    return this.controller.visible ? 'controller' : 'nothing';
  }

  hide(): void {
    this.controller.visible = this.joints.visible = false;
  }

  showController(pose: XRRigidTransform): void {
    this.controller.position.copy(pose.position as unknown as THREE.Vector3);
    this.controller.quaternion.copy(pose.orientation as unknown as THREE.Quaternion);
    this.controller.visible = true;
    this.joints.visible = false;
  }

  showJoints(joints: readonly XRJointPose[]): void {
    const at = new THREE.Matrix4();
    joints.forEach(({ transform, radius }, i) => {
      at.fromArray(transform.matrix).scale(new THREE.Vector3().setScalar(radius ?? 0.008));
      this.joints.setMatrixAt(i, at);
    });
    this.joints.count = joints.length;
    this.joints.instanceMatrix.needsUpdate = true;
    this.joints.visible = true;
    this.controller.visible = false;
  }
}
