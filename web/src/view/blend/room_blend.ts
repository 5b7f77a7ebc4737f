// SPDX-License-Identifier: Apache-2.0
// Blends the surfaces of all sensors into one picture with depth, which is an object of the scene: add `picture` to the
// scene and call `mix` before drawing. Two passes: the nearest surface, then the sum of the surfaces close to it. In a
// headset both eyes share the targets, side by side.
import * as THREE from 'three';
import type { BlendLayer } from './blend_layer';
import { resolveFragmentShader } from './blend_shader';
import type { ModelLayer } from './model_layer';
import { wholePicture, wholePictureVertexShader } from './full_screen_pass';
import { Surroundings } from './surroundings';

/** Checks that this browser can draw into half and full float targets. */
export function canBlend(renderer: THREE.WebGLRenderer): boolean {
  return renderer.extensions.has('EXT_color_buffer_float');
}

export class RoomBlend {
  readonly picture: THREE.Mesh;
  private readonly nearest = new THREE.Scene();
  private readonly mixed = new THREE.Scene();
  private readonly surroundings = new Surroundings();
  private readonly sums: THREE.WebGLRenderTarget;
  private readonly uniforms = {
    uColorSum: { value: null as THREE.Texture | null },
    uDepth: { value: null as THREE.Texture | null },
    uSurroundings: { value: null as THREE.Texture | null },
    uFill: { value: true },
    uMetresFromDepth: { value: new THREE.Vector2() },
  };

  constructor(
    private readonly renderer: THREE.WebGLRenderer,
    private readonly model: ModelLayer,
  ) {
    this.sums = new THREE.WebGLRenderTarget(1, 1, {
      type: THREE.HalfFloatType,
      minFilter: THREE.NearestFilter,
      magFilter: THREE.NearestFilter,
      depthTexture: new THREE.DepthTexture(1, 1, THREE.FloatType),
    });
    this.uniforms.uColorSum.value = this.sums.texture;
    this.uniforms.uDepth.value = this.sums.depthTexture;
    const material = new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: wholePictureVertexShader,
      fragmentShader: resolveFragmentShader,
      uniforms: this.uniforms,
      depthFunc: THREE.AlwaysDepth,
    });
    this.picture = new THREE.Mesh(wholePicture(), material);
    this.picture.frustumCulled = false;
    this.picture.renderOrder = -1; // before all objects that may be in front of it
  }

  add(layer: BlendLayer): void {
    this.nearest.add(layer.nearest);
    this.mixed.add(layer.mixed);
  }

  remove(layer: BlendLayer): void {
    this.nearest.remove(layer.nearest);
    this.mixed.remove(layer.mixed);
    layer.dispose();
  }

  /** Sets whether pixels that no sensor sees are filled with the colour of their surroundings. */
  setFill(fill: boolean): void {
    this.uniforms.uFill.value = fill;
  }

  /** Blends the view of `camera` into targets of the size of the final picture, device pixels. */
  mix(camera: THREE.PerspectiveCamera, width: number, height: number): void {
    const { renderer, sums } = this;
    this.setSize(width, height);
    const target = renderer.getRenderTarget();
    const { autoClear } = renderer;
    const color = renderer.getClearColor(new THREE.Color());
    const alpha = renderer.getClearAlpha();
    renderer.autoClear = false;
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(sums);
    renderer.clear();
    renderer.render(this.nearest, camera);
    renderer.render(this.mixed, camera);
    if (!this.model.isEmpty) renderer.render(this.model.scene, camera);
    renderer.setClearColor(color, alpha);
    renderer.autoClear = autoClear;
    renderer.setRenderTarget(target);
    const { near: near_m, far: far_m } = camera;
    const metresFromDepth = this.uniforms.uMetresFromDepth.value;
    metresFromDepth.set(far_m / (far_m - near_m), (far_m * near_m) / (far_m - near_m));
    if (this.uniforms.uFill.value) this.surroundings.find(renderer, sums, metresFromDepth);
  }

  private setSize(width: number, height: number): void {
    const { sums } = this;
    if (sums.width === width && sums.height === height) return;
    sums.setSize(width, height);
    this.surroundings.setSize(width, height);
    this.uniforms.uSurroundings.value = this.surroundings.texture;
  }
}
