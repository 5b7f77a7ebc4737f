// SPDX-License-Identifier: Apache-2.0
// Finds the sensor whose surface is drawn at each pixel: draws the room off screen with ids instead of pictures. For
// tests and picking; each call costs a full picture. Pixels are CSS pixels of the canvas, y down.
import * as THREE from 'three';
import type { PlacedSensor } from './placed_sensor';
import type { Stage } from './stage';

export const nothing = -1;
const around_px = 2;
const beam_deg = 0.6; // how wide a beam is that meets surfaces
const nearest_m = 0.05;
const farthest_m = 30;

/** Metres along the viewing direction at a pixel of what was read; 0: nothing. */
function distanceIn(numbers: Uint8Array, pixel: number): number {
  return numbers[4 * pixel] ? (256 * numbers[4 * pixel + 1]! + numbers[4 * pixel + 2]!) / 1000 : 0;
}

/** Of the pixels that show something. */
function medianIn(numbers: Uint8Array, pixels: number): number | undefined {
  const distances_m = Array.from({ length: pixels }, (_, i) => distanceIn(numbers, i)).filter((d) => d > 0);
  return distances_m.sort((a, b) => a - b)[distances_m.length >> 1];
}

export class IdPass {
  constructor(private readonly stage: Stage) {}

  /**
   * Sensor id per pixel, row by row from the top; `nothing` where there is no surface. `only`: draws that sensor alone.
   */
  draw(only?: number): { ids: Int32Array; width: number; height: number } {
    const { clientWidth: width, clientHeight: height } = this.stage.canvas;
    const sensors = [...this.stage.room.placed].filter(([id]) => only === undefined || id === only);
    const numbers = this.readIds(sensors, width, height);
    const ids = new Int32Array(width * height);
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const number = numbers[4 * ((height - 1 - y) * width + x)]!;
        ids[y * width + x] = number === 0 ? nothing : sensors[number - 1]![0];
      }
    }
    return { ids, width, height };
  }

  /**
   * The point of the surface in front at a pixel, in the world, as far away as most of the pixels around it: noise and
   * holes of a few pixels do not matter. Undefined where there is none. Draws those pixels only.
   */
  pointAt(x: number, y: number): THREE.Vector3 | undefined {
    const { camera, canvas, room } = this.stage;
    const side = 2 * around_px + 1;
    camera.setViewOffset(canvas.clientWidth, canvas.clientHeight, x - around_px, y - around_px, side, side);
    const numbers = this.readIds([...room.placed], side, side);
    camera.clearViewOffset();
    const distance_m = medianIn(numbers, side * side);
    return distance_m === undefined ? undefined : pixelRay(this.stage, x, y).multiplyScalar(distance_m).add(camera.position);
  }

  /** The same where a beam from a hand meets the room; also in a headset. `ahead` is one metre long. */
  pointAlong(from: THREE.Vector3, ahead: THREE.Vector3): THREE.Vector3 | undefined {
    const side = 2 * around_px + 1;
    const camera = new THREE.PerspectiveCamera(beam_deg, 1, nearest_m, farthest_m);
    camera.position.copy(from);
    camera.lookAt(from.clone().add(ahead));
    const distance_m = medianIn(this.readIds([...this.stage.room.placed], side, side, camera), side * side);
    return distance_m === undefined ? undefined : ahead.clone().multiplyScalar(distance_m).add(from);
  }

  /** The point at every pixel of the picture as it is now, for many questions at once. Draws it once. */
  pointsOfAll(): (x: number, y: number) => THREE.Vector3 | undefined {
    const { camera, canvas, room } = this.stage;
    const { clientWidth: width, clientHeight: height } = canvas;
    const numbers = this.readIds([...room.placed], width, height);
    const eye = camera.clone();
    return (x, y) => {
      const isInside = x >= 0 && y >= 0 && x < width && y < height;
      const distance_m = isInside ? distanceIn(numbers, (height - 1 - y) * width + x) : 0;
      if (!distance_m) return undefined;
      return pixelRay({ camera: eye, canvas }, x, y).multiplyScalar(distance_m).add(eye.position);
    };
  }

  private readIds(sensors: readonly [number, PlacedSensor][], width: number, height: number, camera = this.stage.camera): Uint8Array {
    const { surfaces, scene: room } = this.stage.room;
    const scene = new THREE.Scene();
    sensors.forEach(([, sensor], i) => {
      sensor.surface.setId(i + 1);
      sensor.updateVisible('apart');
      scene.add(sensor.surface.root);
    });
    const numbers = this.readBack(scene, camera, width, height);
    sensors.forEach(([, sensor]) => {
      sensor.surface.setId(0);
      sensor.updateVisible(surfaces);
      room.add(sensor.surface.root);
    });
    return numbers;
  }

  private readBack(scene: THREE.Scene, camera: THREE.Camera, width: number, height: number): Uint8Array {
    const { renderer } = this.stage;
    const before = { target: renderer.getRenderTarget(), xr: renderer.xr.enabled };
    const target = new THREE.WebGLRenderTarget(width, height, { depthBuffer: true });
    const clear = renderer.getClearColor(new THREE.Color());
    renderer.setClearColor(0x000000, 0);
    renderer.xr.enabled = false; // a headset's eyes would take the camera's place
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    const numbers = new Uint8Array(4 * width * height);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, numbers);
    renderer.setRenderTarget(before.target);
    renderer.xr.enabled = before.xr;
    renderer.setClearColor(clear);
    target.dispose();
    return numbers;
  }
}

/** From the eye through the middle of a pixel; one metre long along the viewing direction. */
export function pixelRay({ camera, canvas }: Pick<Stage, 'camera' | 'canvas'>, x: number, y: number): THREE.Vector3 {
  const right = (2 * (x + 0.5)) / canvas.clientWidth - 1;
  const up = 1 - (2 * (y + 0.5)) / canvas.clientHeight;
  const half = Math.tan(THREE.MathUtils.degToRad(camera.fov) / 2);
  return new THREE.Vector3(right * half * camera.aspect, up * half, -1).applyQuaternion(camera.quaternion);
}
