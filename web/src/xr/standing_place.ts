// SPDX-License-Identifier: Apache-2.0
// The pose of the wearer's physical floor in the room: metres, world y up. Pure.
import { Quaternion, Vector3 } from 'three';

export interface StandingPlace {
  readonly x: number; // of the middle of the physical floor
  readonly y: number;
  readonly z: number;
  readonly yaw: number; // counter-clockwise seen from above
}

const up = new Vector3(0, 1, 0);

/** world_from_floor applied to a point. */
export function inWorld(place: StandingPlace, point: Vector3): Vector3 {
  return point
    .clone()
    .applyAxisAngle(up, place.yaw)
    .add(new Vector3(place.x, place.y, place.z));
}

/** floor_from_world: the pose for an offset reference space that reports all poses in world coordinates. */
export function originOffset(place: StandingPlace): { position: Vector3; orientation: Quaternion } {
  const orientation = new Quaternion().setFromAxisAngle(up, -place.yaw);
  const position = new Vector3(-place.x, -place.y, -place.z).applyQuaternion(orientation);
  return { position, orientation };
}

/** Turns about the head, which keeps its position. `head` in world coordinates. */
export function turned(place: StandingPlace, head: Vector3, angle: number): StandingPlace {
  const arm = new Vector3(place.x - head.x, 0, place.z - head.z).applyAxisAngle(up, angle);
  return { x: head.x + arm.x, y: place.y, z: head.z + arm.z, yaw: place.yaw + angle };
}

/** Moves the head above `target`, and the wearer's floor to the height of `target`. */
export function movedTo(place: StandingPlace, head: Vector3, target: Vector3): StandingPlace {
  return { ...place, x: place.x + target.x - head.x, y: target.y, z: place.z + target.z - head.z };
}

/** With this heading, and so that `floorPoint`, of the physical floor, is at `target` in the room. */
export function standingOver(target: Vector3, floorPoint: Vector3, yaw: number): StandingPlace {
  const arm = floorPoint.clone().applyAxisAngle(up, yaw);
  return { x: target.x - arm.x, y: target.y - arm.y, z: target.z - arm.z, yaw };
}

const farthest_m = 8;

/** Where a ray meets the physical floor, both in its space; undefined: nowhere near. */
export function surfaceUnder(from: Vector3, direction: Vector3): Vector3 | undefined {
  const length_m = -from.y / direction.y;
  if (!(length_m > 0 && length_m <= farthest_m)) return undefined;
  return direction.clone().multiplyScalar(length_m).add(from).setY(0);
}

/** Walks by a stick's deflection: forward is the head's horizontal direction. */
export function walked(place: StandingPlace, headYaw: number, right_m: number, forward_m: number): StandingPlace {
  const [sin, cos] = [Math.sin(headYaw), Math.cos(headYaw)];
  return {
    ...place,
    x: place.x + cos * right_m - sin * forward_m,
    z: place.z - sin * right_m - cos * forward_m,
  };
}

/** Angle about the vertical of an object that looks along its own -z. */
export function yawOf(orientation: Quaternion): number {
  const ahead = new Vector3(0, 0, -1).applyQuaternion(orientation);
  return Math.atan2(-ahead.x, -ahead.z);
}
