// SPDX-License-Identifier: Apache-2.0
// One sensor in the scene: its depth grid as a mesh or as points, in world coordinates. Depth u16 millimetres; edges of
// objects are where depth rises by more than 1.2 cm + 2.2 % of the distance from one pixel to the next.
import * as THREE from 'three';
import type { SensorEntry } from '../gen/control_pb';
import type { ViewFrame } from '../stream/protocol';
import { rayTable } from './ray_table';
import { fragmentShader, meshVertexShader, pointVertexShader } from './surface_shader';

export type DrawMode = 'mesh' | 'points';

const edge_m = 0.012;
const edgeSlope = 0.022;
const unseen_m = 0.06;
const noise_mPerM2 = 0.0015; // 1.5 mm at 1 m, 24 mm at 4 m: of the order of time-of-flight and structured-light sensors

function dataTexture(
  data: Uint16Array<ArrayBuffer> | Uint8Array<ArrayBuffer> | Float32Array<ArrayBuffer>,
  width: number,
  height: number,
  format: THREE.PixelFormat,
  type: THREE.TextureDataType,
): THREE.DataTexture {
  const texture = new THREE.DataTexture(data, width, height, format, type);
  texture.minFilter = texture.magFilter = THREE.NearestFilter;
  texture.unpackAlignment = data.BYTES_PER_ELEMENT === 1 ? 4 : data.BYTES_PER_ELEMENT === 2 ? 2 : 4;
  texture.needsUpdate = true;
  return texture;
}

export class SensorSurface {
  readonly root = new THREE.Group();
  readonly width: number;
  readonly height: number;
  hasPicture = false;
  private hasColor = false;
  private readonly depth: THREE.DataTexture;
  private readonly color: THREE.DataTexture;
  private readonly rays: THREE.DataTexture;
  private readonly blind: Uint32Array;
  private readonly uniforms: Record<string, THREE.IUniform>;
  private readonly mesh: THREE.Mesh;
  private readonly points: THREE.Points;
  private step = 0;

  constructor(entry: SensorEntry) {
    const camera = entry.calibration!.depth!;
    this.width = camera.width;
    this.height = camera.height;
    const pixels = camera.width * camera.height;
    const table = rayTable(camera, camera.width, camera.height);
    this.blind = table.blind;
    this.rays = dataTexture(table.rays, this.width, this.height, THREE.RGFormat, THREE.FloatType);
    this.depth = dataTexture(
      new Uint16Array(pixels),
      this.width,
      this.height,
      THREE.RedIntegerFormat,
      THREE.UnsignedShortType,
    );
    this.depth.internalFormat = 'R16UI';
    this.color = dataTexture(
      new Uint8Array(4 * pixels),
      this.width,
      this.height,
      THREE.RGBAFormat,
      THREE.UnsignedByteType,
    );
    this.color.minFilter = this.color.magFilter = THREE.LinearFilter;
    this.uniforms = this.makeUniforms(camera.fx);
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), this.material(meshVertexShader));
    this.points = new THREE.Points(new THREE.BufferGeometry(), this.material(pointVertexShader));
    for (const object of [this.mesh, this.points]) {
      object.frustumCulled = false;
      object.matrixAutoUpdate = false;
      this.root.add(object);
    }
    this.root.matrixAutoUpdate = false;
    this.root.visible = false;
    this.setStep(4);
  }

  /** Where it is, and whether its picture is of now. */
  follow(entry: SensorEntry, connected: boolean): void {
    this.root.matrix.set(...(entry.worldFromDepth as Parameters<THREE.Matrix4['set']>));
    this.root.matrixWorldNeedsUpdate = true;
    this.uniforms.uLive!.value = entry.online && connected ? 1 : 0;
  }

  /** Takes the pixels over until the next render call has uploaded them. */
  show(frame: ViewFrame): void {
    for (const pixel of this.blind) frame.depth_mm[pixel] = 0;
    this.depth.image.data = frame.depth_mm;
    this.depth.needsUpdate = true;
    if (frame.rgba || this.hasColor) {
      this.color.image.data = frame.rgba ?? new Uint8Array(4 * this.width * this.height);
      this.color.needsUpdate = true;
    }
    this.hasColor = frame.rgba !== undefined;
    this.hasPicture = true;
  }

  /** Uploads what `show` took over, drawn or not. */
  upload(renderer: THREE.WebGLRenderer): void {
    renderer.initTexture(this.depth);
    renderer.initTexture(this.color);
  }

  setMode(mode: DrawMode): void {
    this.mesh.visible = mode === 'mesh';
    this.points.visible = mode === 'points';
  }

  /** Draws every `step`-th pixel of every `step`-th row; as points, which are cheaper, twice as finely. */
  setStep(step: number): void {
    if (step === this.step) return;
    this.step = step;
    const columns = Math.floor((this.width - 1) / step);
    const rows = Math.floor((this.height - 1) / step);
    setGrid(this.mesh, step, columns, rows, 6);
    const pointStep = Math.max(1, Math.round(step / 2));
    setGrid(this.points, pointStep, Math.ceil(this.width / pointStep), Math.ceil(this.height / pointStep), 1);
  }

  /** Screen pixels that a metre takes up at a distance of a metre. */
  setPixelsPerUnit(pixels: number): void {
    this.uniforms.uPixelsPerUnit!.value = pixels;
  }

  /** Draws this number (1 to 255) in the red channel instead of the picture; 0 for the picture. */
  setId(id: number): void {
    this.uniforms.uId!.value = id;
  }

  dispose(): void {
    for (const texture of [this.depth, this.color, this.rays]) texture.dispose();
    for (const object of [this.mesh, this.points]) {
      object.geometry.dispose();
      (object.material as THREE.Material).dispose();
    }
  }

  private makeUniforms(focal: number): Record<string, THREE.IUniform> {
    return {
      uDepth: { value: this.depth },
      uColor: { value: this.color },
      uRays: { value: this.rays },
      uSize: { value: new THREE.Vector2(this.width, this.height) },
      uNoise: { value: noise_mPerM2 },
      uUnseen_m: { value: unseen_m },
      uEdge_m: { value: edge_m },
      uEdgeSlope: { value: edgeSlope },
      uPixelsPerUnit: { value: 1 },
      uFocal: { value: focal },
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
