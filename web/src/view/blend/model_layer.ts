// SPDX-License-Identifier: Apache-2.0
// The room's model in the blended picture: behind everything that sensors show now or have in their backgrounds, where
// these leave pixels empty. Drawn after them, with depths beyond theirs.
import * as THREE from 'three';
import type { DecodedModel } from '../../model/model_worker';
import { passPrecision } from './full_screen_pass';
import { modelDepth } from './blend_shader';

const vertexShader = /* glsl */ `${passPrecision}
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
in vec3 position;
in vec3 color;
out vec3 vColor;
out float vAway_m;
void main() {
  vec4 point = modelViewMatrix * vec4(position, 1.0);
  vColor = color;
  vAway_m = -point.z;
  gl_Position = projectionMatrix * point;
}
`;

const fragmentShader = /* glsl */ `${passPrecision}${modelDepth}
in vec3 vColor;
in float vAway_m;
out vec4 colorSum;
void main() {
  colorSum = vec4(vColor, 1.0);
  gl_FragDepth = depthOfModel(vAway_m);
}
`;

export class ModelLayer {
  readonly scene = new THREE.Scene();
  private readonly pieces = new Map<string, THREE.Mesh>();
  private readonly material = new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader,
    fragmentShader,
    side: THREE.FrontSide,
    blending: THREE.NoBlending,
  });

  constructor() {
    this.scene.matrixWorldAutoUpdate = false; // nothing of it moves
  }

  get isEmpty(): boolean {
    return this.pieces.size === 0;
  }

  get triangles(): number {
    return [...this.pieces.values()].reduce((sum, { geometry }) => sum + geometry.index!.count / 3, 0);
  }

  take({ isWhole, pieces }: Pick<DecodedModel, 'isWhole' | 'pieces'>): void {
    if (isWhole) [...this.pieces.keys()].forEach((key) => this.remove(key));
    for (const { key, geometry } of pieces) {
      this.remove(key);
      if (!geometry) continue;
      const made = new THREE.BufferGeometry();
      made.setAttribute('position', new THREE.BufferAttribute(geometry.positions, 3));
      made.setAttribute('color', new THREE.BufferAttribute(geometry.colors, 3, true));
      made.setIndex(new THREE.BufferAttribute(geometry.indices, 1));
      made.computeBoundingSphere(); // pieces that are out of view are not drawn
      const mesh = new THREE.Mesh(made, this.material);
      mesh.matrixAutoUpdate = false;
      this.pieces.set(key, mesh);
      this.scene.add(mesh);
    }
  }

  private remove(key: string): void {
    const piece = this.pieces.get(key);
    if (!piece) return;
    this.scene.remove(piece);
    piece.geometry.dispose();
    this.pieces.delete(key);
  }
}
