// SPDX-License-Identifier: Apache-2.0
// A fragment shader that runs for every pixel of a render target, in place of a compute shader, which WebGL 2 lacks.
// Every pixel has to be written.
import * as THREE from 'three';

const vertexShader = /* glsl */ `
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
`;

export const passPrecision = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
`;

/** Three vertices that cover the picture, without buffers. */
export function wholePicture(): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setDrawRange(0, 3);
  return geometry;
}

export const wholePictureVertexShader = vertexShader;

export class FullScreenPass {
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.Camera();
  private readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.RawShaderMaterial>;

  constructor(
    fragmentShader: string,
    readonly uniforms: Record<string, THREE.IUniform>,
    blending: Partial<THREE.ShaderMaterialParameters> = {},
  ) {
    const material = new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader,
      fragmentShader: passPrecision + fragmentShader,
      uniforms,
      depthTest: false,
      depthWrite: false,
      ...blending,
    });
    this.mesh = new THREE.Mesh(wholePicture(), material);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  /** To be called within `withoutHeadset`. */
  run(renderer: THREE.WebGLRenderer, target: THREE.WebGLRenderTarget): void {
    renderer.setRenderTarget(target);
    renderer.render(this.scene, this.camera);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/**
 * Runs passes that are not views of the room: once each, also with two eyes, and without clearing the target before.
 */
export function withoutHeadset(renderer: THREE.WebGLRenderer, run: () => void): void {
  const target = renderer.getRenderTarget();
  const { autoClear } = renderer;
  const { enabled } = renderer.xr;
  renderer.autoClear = false;
  renderer.xr.enabled = false;
  run();
  renderer.xr.enabled = enabled;
  renderer.autoClear = autoClear;
  renderer.setRenderTarget(target);
}
