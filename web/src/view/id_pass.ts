// SPDX-License-Identifier: Apache-2.0
// Finds the sensor whose surface is drawn at each pixel: draws the room off screen with ids instead of pictures. For
// tests and picking; each call costs a full picture. Pixels are CSS pixels of the canvas, y down.
import * as THREE from 'three';
import type { PlacedSensor } from './placed_sensor';
import type { Stage } from './stage';

export const nothing = -1;

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

  /** The point of the surface in front at a pixel, in the world; undefined where there is none. Draws that pixel only. */
  pointAt(x: number, y: number): THREE.Vector3 | undefined {
    const { camera, canvas, room } = this.stage;
    camera.setViewOffset(canvas.clientWidth, canvas.clientHeight, x, y, 1, 1);
    const [number, high, low] = this.readIds([...room.placed], 1, 1);
    camera.clearViewOffset();
    if (!number) return undefined;
    const distance_m = (256 * high! + low!) / 1000;
    return pixelRay(this.stage, x, y).multiplyScalar(distance_m).add(camera.position);
  }

  private readIds(sensors: readonly [number, PlacedSensor][], width: number, height: number): Uint8Array {
    const { isMixing, scene: room } = this.stage.room;
    const scene = new THREE.Scene();
    sensors.forEach(([, sensor], i) => {
      sensor.surface.setId(i + 1);
      sensor.updateVisible(false);
      scene.add(sensor.surface.root);
    });
    const numbers = this.readBack(scene, width, height);
    sensors.forEach(([, sensor]) => {
      sensor.surface.setId(0);
      sensor.updateVisible(isMixing);
      room.add(sensor.surface.root);
    });
    return numbers;
  }

  private readBack(scene: THREE.Scene, width: number, height: number): Uint8Array {
    const { renderer, camera } = this.stage;
    const target = new THREE.WebGLRenderTarget(width, height, { depthBuffer: true });
    const clear = renderer.getClearColor(new THREE.Color());
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    const numbers = new Uint8Array(4 * width * height);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, numbers);
    renderer.setRenderTarget(null);
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
