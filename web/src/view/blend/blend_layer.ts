// SPDX-License-Identifier: Apache-2.0
// One blended surface of a sensor: the live surface, the backs of what is live and not background, or the background
// model's surface.
import * as THREE from 'three';
import { edge_m, edgeSlope } from '../sensor_surface';
import { mixFragmentShader, mixVertexShader, nearestFragmentShader, nearestVertexShader } from './blend_shader';
import type { BackgroundModel } from './background_model';

const exponent = 4; // weight of directions: higher is sharper, lower hides seams

/**
 * `backs`: of what is before a known background or moves before an unknown one, such as a person: seen where no sensor
 * sees the near side, for example a leg's side between the sensors in front of and behind it. Without them one sees
 * through the leg.
 */
export type LayerKind = 'live' | 'backs' | 'background';

/** How far behind its place a layer is drawn, so that live front sides there hide it. */
const setback_m: Record<LayerKind, number> = { live: 0, backs: 0.04, background: 0.03 };

function drawn(material: THREE.RawShaderMaterial): THREE.Mesh {
  const mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
  mesh.frustumCulled = false;
  mesh.matrixAutoUpdate = false;
  return mesh;
}

export class BlendLayer {
  readonly nearest: THREE.Mesh;
  readonly mixed: THREE.Mesh;
  private readonly uniforms: Record<string, THREE.IUniform>;

  constructor(
    private readonly memory: BackgroundModel,
    private readonly kind: LayerKind,
  ) {
    const { lens, rays } = memory.sensor;
    this.uniforms = {
      uDepth_m: { value: null },
      uQuality: { value: null },
      uRays: { value: rays },
      uStep: { value: 1 },
      uEdge_m: { value: edge_m },
      uEdgeSlope: { value: edgeSlope },
      uSetback_m: { value: setback_m[kind] },
      uMotion: { value: null },
      uAhead_s: { value: 0 },
      uBehind_m: { value: null },
      uForegroundOnly: { value: kind === 'backs' },
      uIsBackground: { value: kind === 'background' },
      uExponent: { value: exponent },
      uColor: { value: null },
      uSize: { value: new THREE.Vector2(lens.width, lens.height) },
      uLive: { value: 1 },
    };
    const glsl = { glslVersion: THREE.GLSL3, uniforms: this.uniforms, side: kind === 'backs' ? THREE.BackSide : THREE.FrontSide } as const;
    this.nearest = drawn(
      new THREE.RawShaderMaterial({
        ...glsl,
        vertexShader: nearestVertexShader,
        fragmentShader: nearestFragmentShader,
        colorWrite: false,
      }),
    );
    this.mixed = drawn(
      new THREE.RawShaderMaterial({
        ...glsl,
        vertexShader: mixVertexShader,
        fragmentShader: mixFragmentShader,
        depthWrite: false,
        depthFunc: THREE.LessEqualDepth,
        blending: THREE.CustomBlending,
        blendEquation: THREE.AddEquation,
        blendSrc: THREE.OneFactor,
        blendDst: THREE.OneFactor,
      }),
    );
  }

  setVisible(visible: boolean): void {
    this.nearest.visible = this.mixed.visible = visible;
  }

  place(worldFromDepth: THREE.Matrix4, live: number): void {
    this.uniforms.uLive!.value = live;
    for (const mesh of [this.nearest, this.mixed]) {
      mesh.matrix.copy(worldFromDepth);
      mesh.matrixWorldNeedsUpdate = true;
    }
  }

  /** Draws what moves where it is this much after the newest picture. */
  setAhead(ahead_s: number): void {
    this.uniforms.uAhead_s!.value = this.kind !== 'background' && this.memory.moves ? ahead_s : 0;
  }

  /** Takes over the memory's current textures. */
  refresh(): void {
    const { grids, current, sensor } = this.memory;
    const { uniforms } = this;
    const live = this.kind !== 'background';
    uniforms.uDepth_m!.value = (live ? grids.live : grids.background).texture;
    uniforms.uMotion!.value = grids.motion.texture;
    uniforms.uBehind_m!.value = (this.memory.moves ? grids.motion : grids.background).texture;
    uniforms.uQuality!.value = grids.quality.texture;
    uniforms.uColor!.value = live ? sensor.color : current.meanColor;
    uniforms.uStep!.value = grids.step;
    const squares = (grids.live.width - 1) * (grids.live.height - 1);
    for (const mesh of [this.nearest, this.mixed]) mesh.geometry.setDrawRange(0, 6 * squares);
  }

  dispose(): void {
    for (const mesh of [this.nearest, this.mixed]) {
      mesh.geometry.dispose();
      (mesh.material as THREE.Material).dispose();
    }
  }
}
