// SPDX-License-Identifier: Apache-2.0
// The point of the room at a pixel of the canvas: of the surface in front, else of the floor where no sensor sees
// anything. Each call draws a few pixels. Pixels are CSS pixels, y down; points are in the world, metres.
import type { Vector3 } from 'three';
import { floorPoint } from './going_there';
import { IdPass, pixelRay } from './id_pass';
import type { Stage } from './stage';

const floorWithin_m = 30; // a floor that no sensor sees

export class SurfacePick {
  constructor(private readonly stage: Stage) {}

  /** Undefined where there is nothing, and in a headset, which draws by itself. */
  at(x: number, y: number): Vector3 | undefined {
    const { stage } = this;
    if (stage.renderer.xr.isPresenting) return undefined;
    return new IdPass(stage).pointAt(x, y) ?? this.floorAt(x, y);
  }

  /** The same for many pixels of the picture as it is now. Draws it once. */
  many(): (x: number, y: number) => Vector3 | undefined {
    const seen = new IdPass(this.stage).pointsOfAll();
    return (x, y) => seen(x, y) ?? this.floorAt(x, y);
  }

  private floorAt(x: number, y: number): Vector3 | undefined {
    return floorPoint(this.stage.camera.position, pixelRay(this.stage, x, y), floorWithin_m);
  }

  /** Along the ray where there is nothing to meet. */
  orAhead(x: number, y: number, distance_m: number): Vector3 {
    return this.at(x, y) ?? pixelRay(this.stage, x, y).setLength(distance_m).add(this.stage.camera.position);
  }
}
