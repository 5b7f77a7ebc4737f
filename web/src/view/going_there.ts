// SPDX-License-Identifier: Apache-2.0
// Going to a point of the room: where one stands then, and the way there. Pure.
import { Vector3 } from 'three';
import { between, lookFrom, type ViewState } from './view_state';

const floor_m = 0.25; // what is lower is taken for the floor
const standoff_m = 1; // in front of anything else
const steepest = -0.3; // viewing direction on arrival on the floor, radians
const least_ms = 250;
const most_ms = 900;
const msPerMetre = 180;

/** Where a ray from the eye meets the floor; undefined if it does not within `most_m`. */
export function floorPoint(eye: Vector3, ray: Vector3, most_m: number): Vector3 | undefined {
  if (ray.y >= 0 || eye.y <= 0) return undefined;
  const way = ray.clone().multiplyScalar(-eye.y / ray.y);
  return way.length() <= most_m ? way.add(eye) : undefined;
}

/** On the floor one stands upon the point; of anything else one stands in front and looks at it. The height stays. */
export function viewAt(view: ViewState, point: Vector3): ViewState {
  const level = new Vector3(point.x - view.position.x, 0, point.z - view.position.z);
  if (point.y < floor_m) {
    const position = view.position.clone().add(level);
    return { ...view, position, pitch: Math.max(view.pitch, steepest) };
  }
  const forward_m = level.length() - standoff_m;
  const position = view.position.clone().add(level.setLength(Math.max(0, forward_m)));
  return lookFrom(position, point);
}

/** A smooth way from one view to another. */
export class Glide {
  private began_ms: number | undefined;
  private readonly duration_ms: number;

  constructor(
    private readonly from: ViewState,
    private readonly to: ViewState,
  ) {
    const way_m = from.position.distanceTo(to.position);
    this.duration_ms = Math.min(most_ms, Math.max(least_ms, msPerMetre * way_m));
  }

  /** The view now, and whether it is the last one. The first call begins the way. */
  at(now_ms: number): { view: ViewState; isOver: boolean } {
    this.began_ms ??= now_ms;
    const time = Math.min(1, Math.max(0, (now_ms - this.began_ms) / this.duration_ms));
    const share = time * time * (3 - 2 * time);
    return { view: time === 1 ? this.to : between(this.from, this.to, share), isOver: time === 1 };
  }
}
