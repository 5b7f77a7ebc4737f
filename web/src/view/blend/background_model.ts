// SPDX-License-Identifier: Apache-2.0
// One sensor's live surface and background model, ready for drawing: textures in a grid of every `step`-th pixel.
// Updated by BackgroundUpdater.
import * as THREE from 'three';
import type { SensorPictures } from '../sensor_pictures';

interface Layout {
  format: THREE.PixelFormat;
  type: THREE.TextureDataType;
  linear?: boolean;
}

const metres: Layout = { format: THREE.RedFormat, type: THREE.FloatType };
const share: Layout = { format: THREE.RedFormat, type: THREE.UnsignedByteType };
const weight: Layout = { format: THREE.RedFormat, type: THREE.HalfFloatType };
const readings: Layout = { format: THREE.RGBAFormat, type: THREE.FloatType };
const motion: Layout = { format: THREE.RGBAFormat, type: THREE.HalfFloatType };
const meanColor: Layout = { format: THREE.RGBAFormat, type: THREE.HalfFloatType, linear: true };

function target(width: number, height: number, ...layouts: Layout[]): THREE.WebGLRenderTarget {
  const made = new THREE.WebGLRenderTarget(width, height, { count: layouts.length, depthBuffer: false });
  made.textures.forEach((texture, i) => {
    const { format, type, linear } = layouts[i]!;
    texture.format = format;
    texture.type = type;
    texture.minFilter = texture.magFilter = linear ? THREE.LinearFilter : THREE.NearestFilter;
    texture.generateMipmaps = false;
  });
  return made;
}

/** Textures of the full picture size. */
export class BackgroundTextures {
  readonly target: THREE.WebGLRenderTarget;

  constructor(width: number, height: number) {
    this.target = target(width, height, readings, meanColor, metres);
  }

  get readings(): THREE.Texture {
    return this.target.textures[0]!;
  }

  get meanColor(): THREE.Texture {
    return this.target.textures[1]!;
  }

  /** The newest depth, metres. */
  get newest(): THREE.Texture {
    return this.target.textures[2]!;
  }
}

/** Textures of the grid's size. */
export class Grids {
  readonly repaired: THREE.WebGLRenderTarget;
  readonly live: THREE.WebGLRenderTarget;
  readonly inRow: THREE.WebGLRenderTarget;
  readonly quality: THREE.WebGLRenderTarget;
  readonly background: THREE.WebGLRenderTarget;
  readonly carved: THREE.WebGLRenderTarget;
  readonly carvedLive: THREE.WebGLRenderTarget;
  readonly motion: THREE.WebGLRenderTarget; // motion_shader.ts; of the newest picture if something moves in it
  isCarved = false; // carved contains data
  isLiveCarved: boolean | undefined; // carvedLive contains places; undefined: it contains nothing yet

  constructor(
    readonly step: number,
    width: number,
    height: number,
  ) {
    const columns = Math.floor((width - 1) / step) + 1;
    const rows = Math.floor((height - 1) / step) + 1;
    [this.repaired, this.live, this.background] = [0, 1, 2].map(() => target(columns, rows, metres)) as [
      THREE.WebGLRenderTarget,
      THREE.WebGLRenderTarget,
      THREE.WebGLRenderTarget,
    ];
    [this.inRow, this.carved, this.carvedLive] = [0, 1, 2].map(() => target(columns, rows, share)) as [
      THREE.WebGLRenderTarget,
      THREE.WebGLRenderTarget,
      THREE.WebGLRenderTarget,
    ];
    this.quality = target(columns, rows, weight);
    this.motion = target(columns, rows, motion);
  }

  dispose(): void {
    const { repaired, live, inRow, quality, background, carved, carvedLive, motion } = this;
    for (const each of [repaired, live, inRow, quality, background, carved, carvedLive, motion]) each.dispose();
  }
}

export class BackgroundModel {
  current: BackgroundTextures;
  spare: BackgroundTextures; // target of the next update
  grids: Grids;
  isBlank = true; // contains no background
  moves = false; // something in the picture that the grids show
  pictures = 0;

  constructor(readonly sensor: SensorPictures) {
    const { width, height } = sensor.lens;
    this.current = new BackgroundTextures(width, height);
    this.spare = new BackgroundTextures(width, height);
    this.grids = new Grids(4, width, height);
  }

  /** True when the grid has changed; the new grid is empty until the next refresh. */
  setStep(step: number): boolean {
    if (step === this.grids.step) return false;
    this.grids.dispose();
    this.grids = new Grids(step, this.sensor.lens.width, this.sensor.lens.height);
    return true;
  }

  /** The sensor was moved: its background model is invalid. */
  forget(): void {
    this.isBlank = true;
  }

  swap(): void {
    [this.current, this.spare] = [this.spare, this.current];
  }

  dispose(): void {
    this.current.target.dispose();
    this.spare.target.dispose();
    this.grids.dispose();
  }
}
