// SPDX-License-Identifier: Apache-2.0
// One sensor's unblended surface: its depth grid as a mesh or as points, in world coordinates. A depth rise of more
// than 1.2 cm + 2.2 % of the distance from one pixel to the next is an object edge.
import * as THREE from 'three';
import type { SensorPictures } from './sensor_pictures';
import { fragmentShader, meshVertexShader, pointVertexShader } from './surface_shader';

export type SurfaceKind = 'mesh' | 'points';

export const edge_m = 0.012;
export const edgeSlope = 0.022;
const unseen_m = 0.06;
const noise_mPerM2 = 0.0015; // 1.5 mm at 1 m, 24 mm at 4 m: of the order of time-of-flight and structured-light sensors

export class SensorSurface {
  readonly root = new THREE.Group();
  private readonly uniforms: Record<string, THREE.IUniform>;
  private readonly mesh: THREE.Mesh;
  private readonly points: THREE.Points;
  private step = 0;

  constructor(private readonly pictures: SensorPictures) {
    this.uniforms = this.makeUniforms();
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material(meshVertexShader));
    this.points = new THREE.Points(new THREE.BufferGeometry(), this.material(pointVertexShader));
    for (const object of [this.mesh, this.points]) {
      object.frustumCulled = false;
      object.matrixAutoUpdate = false;
      this.root.add(object);
    }
    this.root.matrixAutoUpdate = false;
    this.setStep(4);
  }

  /** `live`: 1, or 0 when the picture is outdated. */
  place(worldFromDepth: THREE.Matrix4, live: number): void {
    this.root.matrix.copy(worldFromDepth);
    this.root.matrixWorldNeedsUpdate = true;
    this.uniforms.uLive!.value = live;
  }

  setKind(kind: SurfaceKind): void {
    this.mesh.visible = kind === 'mesh';
    this.points.visible = kind === 'points';
  }

  /** Draws every `step`-th pixel of every `step`-th row; points, which are cheaper, twice as finely. */
  setStep(step: number): void {
    if (step === this.step) return;
    this.step = step;
    const { width, height } = this.pictures.lens;
    const columns = Math.floor((width - 1) / step);
    const rows = Math.floor((height - 1) / step);
    setGrid(this.mesh, step, columns, rows, 6);
    const pointStep = Math.max(1, Math.round(step / 2));
    setGrid(this.points, pointStep, Math.ceil(width / pointStep), Math.ceil(height / pointStep), 1);
  }

  /** Size in screen pixels of a metre at a distance of a metre. */
  setPixelsPerUnit(pixels: number): void {
    this.uniforms.uPixelsPerUnit!.value = pixels;
  }

  /**
   * Draws `id` (1 to 255) in the red channel instead of the picture, and the distance along the viewing direction in
   * millimetres in green (high byte) and blue; 0 draws the picture.
   */
  setId(id: number): void {
    this.uniforms.uId!.value = id;
  }

  dispose(): void {
    for (const object of [this.mesh, this.points]) {
      object.geometry.dispose();
      (object.material as THREE.Material).dispose();
    }
  }

  private makeUniforms(): Record<string, THREE.IUniform> {
    const { lens, depth, color, rays } = this.pictures;
    return {
      uDepth: { value: depth },
      uColor: { value: color },
      uRays: { value: rays },
      uSize: { value: new THREE.Vector2(lens.width, lens.height) },
      uNoise: { value: noise_mPerM2 },
      uUnseen_m: { value: unseen_m },
      uEdge_m: { value: edge_m },
      uEdgeSlope: { value: edgeSlope },
      uPixelsPerUnit: { value: 1 },
      uFocal: { value: lens.fx },
      uLive: { value: 1 },
      uId: { value: 0 },
    };
  }

  private material(vertexShader: string): THREE.RawShaderMaterial {
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: { ...this.uniforms, uCells: { value: new THREE.Vector2() }, uStep: { value: 1 } },
      side: THREE.FrontSide,
    });
  }
}

function setGrid(
  object: THREE.Mesh | THREE.Points,
  step: number,
  columns: number,
  rows: number,
  verticesPerCell: number,
): void {
  const { uniforms } = object.material as THREE.RawShaderMaterial;
  uniforms.uStep!.value = step;
  (uniforms.uCells!.value as THREE.Vector2).set(columns, rows);
  object.geometry.setDrawRange(0, verticesPerCell * columns * rows);
}
