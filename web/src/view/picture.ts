// SPDX-License-Identifier: Apache-2.0
// Reads back the room's picture as drawn now. For tests. Pixels are CSS pixels of the canvas, rows from the top, RGBA.
import * as THREE from 'three';
import type { Stage } from './stage';

export interface Picture {
  rgba: Uint8Array;
  width: number;
  height: number;
}

export function takePicture({ renderer, room, camera, canvas }: Stage): Picture {
  const { clientWidth: width, clientHeight: height } = canvas;
  const target = new THREE.WebGLRenderTarget(width, height, { depthBuffer: true });
  renderer.setRenderTarget(target);
  room.render(camera, width, height);
  const upsideDown = new Uint8Array(4 * width * height);
  renderer.readRenderTargetPixels(target, 0, 0, width, height, upsideDown);
  renderer.setRenderTarget(null);
  target.dispose();
  const rgba = new Uint8Array(upsideDown.length);
  for (let y = 0; y < height; y++) {
    const row = 4 * width * (height - 1 - y);
    rgba.set(upsideDown.subarray(row, row + 4 * width), 4 * width * y);
  }
  return { rgba, width, height };
}
