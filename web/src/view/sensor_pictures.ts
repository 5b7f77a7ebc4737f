// SPDX-License-Identifier: Apache-2.0
// One sensor's newest pictures on the graphics processor: depth as u16 millimetres (0 = no reading), colour in the depth
// grid (alpha: the colour camera saw the surface), and the lens as a table of rays.
import * as THREE from 'three';
import type { Intrinsics } from '../gen/control_pb';
import { flowChannels, flowSize } from '../codec/scene_flow';
import type { ViewFrame } from '../stream/protocol';
import { rayTable } from './ray_table';

type Pixels = Uint16Array<ArrayBuffer> | Uint8Array<ArrayBuffer> | Float32Array<ArrayBuffer>;

interface Size {
  width: number;
  height: number;
}

function dataTexture(data: Pixels, { width, height }: Size, format: THREE.PixelFormat, type: THREE.TextureDataType) {
  const texture = new THREE.DataTexture(data, width, height, format, type);
  texture.minFilter = texture.magFilter = THREE.NearestFilter;
  texture.unpackAlignment = data.BYTES_PER_ELEMENT === 2 ? 2 : 4;
  texture.needsUpdate = true;
  return texture;
}

export class SensorPictures {
  readonly depth: THREE.DataTexture;
  readonly color: THREE.DataTexture;
  readonly rays: THREE.DataTexture;
  readonly flow: THREE.DataTexture; // codec/scene_flow.ts
  moves = false; // something in the newest picture, as `flow` says
  hasPicture = false;
  private hasColor = false;
  private readonly blind: Uint32Array;

  constructor(readonly lens: Intrinsics) {
    const pixels = lens.width * lens.height;
    const table = rayTable(lens, lens.width, lens.height);
    this.blind = table.blind;
    this.rays = dataTexture(table.rays, lens, THREE.RGFormat, THREE.FloatType);
    this.depth = dataTexture(new Uint16Array(pixels), lens, THREE.RedIntegerFormat, THREE.UnsignedShortType);
    this.depth.internalFormat = 'R16UI';
    this.color = dataTexture(new Uint8Array(4 * pixels), lens, THREE.RGBAFormat, THREE.UnsignedByteType);
    const cells = flowSize(lens);
    const still = new Float32Array(flowChannels * cells.width * cells.height);
    this.flow = dataTexture(still, cells, THREE.RGBAFormat, THREE.FloatType);
    this.color.minFilter = this.color.magFilter = THREE.LinearFilter;
  }

  /** Uploads the frame; its pixels are read until the next picture has been drawn. */
  show(frame: ViewFrame, renderer: THREE.WebGLRenderer): void {
    for (const pixel of this.blind) frame.depth_mm[pixel] = 0;
    this.depth.image.data = frame.depth_mm;
    this.depth.needsUpdate = true;
    if (frame.rgba || this.hasColor) {
      this.color.image.data = frame.rgba ?? new Uint8Array(4 * this.lens.width * this.lens.height);
      this.color.needsUpdate = true;
    }
    this.moves = frame.flow !== undefined;
    if (frame.flow) {
      this.flow.image.data = frame.flow;
      this.flow.needsUpdate = true;
      renderer.initTexture(this.flow);
    }
    this.hasColor = frame.rgba !== undefined;
    this.hasPicture = true;
    renderer.initTexture(this.depth);
    renderer.initTexture(this.color);
  }

  /** Nothing is seen until the next frame. */
  clear(renderer: THREE.WebGLRenderer): void {
    const pixels = this.lens.width * this.lens.height;
    this.moves = false;
    this.depth.image.data = new Uint16Array(pixels);
    this.color.image.data = new Uint8Array(4 * pixels);
    for (const texture of [this.depth, this.color]) {
      texture.needsUpdate = true;
      renderer.initTexture(texture);
    }
  }

  dispose(): void {
    for (const texture of [this.depth, this.color, this.rays, this.flow]) texture.dispose();
  }
}
