// SPDX-License-Identifier: Apache-2.0
// The viewer's position and direction, and functions that change them. World: metres, y up. Yaw 0 looks along -z and
// grows to the left, pitch is up. `distance` is the distance to the pivot, the centre of orbiting. Pure.
import { Euler, Matrix4, Quaternion, Vector3 } from 'three';

export interface ViewState {
  readonly position: Vector3;
  readonly yaw: number;
  readonly pitch: number;
  readonly distance: number;
}

type Part = Record<'x' | 'y' | 'z' | 'qx' | 'qy' | 'qz' | 'qw', number>;

export const maxPitch = 1.55; // a little less than straight up
export const lowestEye_m = 0.1; // above the floor
const minDistance_m = 0.3;
export const maxDistance_m = 25; // a room of unknown size is still in view

function clamp(value: number, low: number, high: number): number {
  return Math.min(high, Math.max(low, value));
}

export function direction({ yaw, pitch }: Pick<ViewState, 'yaw' | 'pitch'>): Vector3 {
  return new Vector3(-Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), -Math.cos(yaw) * Math.cos(pitch));
}

export function pivot(view: ViewState): Vector3 {
  return direction(view).multiplyScalar(view.distance).add(view.position);
}

/** World from viewer: x right, y up, -z forward. */
export function orientation({ yaw, pitch }: Pick<ViewState, 'yaw' | 'pitch'>): Quaternion {
  return new Quaternion().setFromEuler(new Euler(pitch, yaw, 0, 'YXZ'));
}

export function lookFrom(position: Vector3, target: Vector3): ViewState {
  const gaze = target.clone().sub(position);
  const distance = clamp(gaze.length(), minDistance_m, maxDistance_m);
  const level = Math.hypot(gaze.x, gaze.z);
  return {
    position: position.clone(),
    yaw: level > 1e-6 ? Math.atan2(-gaze.x, -gaze.z) : 0,
    pitch: clamp(Math.atan2(gaze.y, level), -maxPitch, maxPitch),
    distance,
  };
}

/** `worldFromViewer` row-major 4x4. Roll is dropped: the horizon stays level. */
export function viewFromMatrix(worldFromViewer: readonly number[], distance: number): ViewState {
  const matrix = new Matrix4().set(...(worldFromViewer as Parameters<Matrix4['set']>));
  const position = new Vector3().setFromMatrixPosition(matrix);
  const gaze = new Vector3(0, 0, -1).transformDirection(matrix);
  return lookFrom(position, gaze.multiplyScalar(distance).add(position));
}

/** The view of a headset's wearer; roll is dropped. */
export function viewFromBody({ x, y, z, qx, qy, qz, qw }: Part, distance: number): ViewState {
  const position = new Vector3(x, y, z);
  const gaze = new Vector3(0, 0, -1).applyQuaternion(new Quaternion(qx, qy, qz, qw));
  return lookFrom(position, gaze.multiplyScalar(distance).add(position));
}

/** Turns the head in place. */
export function look(view: ViewState, dYaw: number, dPitch: number): ViewState {
  return { ...view, yaw: view.yaw + dYaw, pitch: clamp(view.pitch + dPitch, -maxPitch, maxPitch) };
}

/** Moves around the pivot, which stays at the same place on the screen. The eye does not go under the floor. */
export function orbit(view: ViewState, dYaw: number, dPitch: number): ViewState {
  const centre = pivot(view);
  const steepest = Math.asin(clamp((centre.y - lowestEye_m) / view.distance, -1, 1)); // there the eye touches the floor
  const turned = look(view, dYaw, Math.min(dPitch, Math.max(0, steepest - view.pitch)));
  return { ...turned, position: centre.sub(direction(turned).multiplyScalar(view.distance)) };
}

/** Moves parallel to the picture, metres. */
export function pan(view: ViewState, right_m: number, up_m: number): ViewState {
  const move = new Vector3(right_m, up_m, 0).applyQuaternion(orientation(view));
  return { ...view, position: move.add(view.position) };
}

/**
 * Moves to `factor` times the distance from the pivot, at most to `most_m`, so that the room stays in view. At the
 * minimum distance it pushes the pivot ahead.
 */
export function dolly(view: ViewState, factor: number, most_m = maxDistance_m): ViewState {
  const wanted_m = view.distance * factor;
  const distance = clamp(wanted_m, minDistance_m, most_m);
  const forward_m = view.distance - Math.min(wanted_m, most_m);
  return { ...view, distance, position: direction(view).multiplyScalar(forward_m).add(view.position) };
}

/** The view on the straight way from `a` to `b`, at `share` 0..1 of it; turns the shorter way round. */
export function between(a: ViewState, b: ViewState, share: number): ViewState {
  const turn = Math.atan2(Math.sin(b.yaw - a.yaw), Math.cos(b.yaw - a.yaw));
  return {
    position: a.position.clone().lerp(b.position, share),
    yaw: a.yaw + share * turn,
    pitch: a.pitch + share * (b.pitch - a.pitch),
    distance: a.distance + share * (b.distance - a.distance),
  };
}

/** Walks horizontally, and `up_m` vertically, whatever the pitch. Metres. */
export function walk(view: ViewState, forward_m: number, right_m: number, up_m: number): ViewState {
  const sin = Math.sin(view.yaw);
  const cos = Math.cos(view.yaw);
  const move = new Vector3(-sin * forward_m + cos * right_m, up_m, -cos * forward_m - sin * right_m);
  return { ...view, position: move.add(view.position) };
}
