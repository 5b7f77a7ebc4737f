// SPDX-License-Identifier: Apache-2.0
// Where a viewer may go: above the floor, and not so far that the room can no longer be found. Pure.
import { Vector3 } from 'three';
import { lowestEye_m, type ViewState } from './view_state';

export const farthest_m = 25;

/** The view with its position moved to the nearest one that is permitted. `home` is what the first view looked at. */
export function withinReach(view: ViewState, home: Vector3): ViewState {
  const fromHome = view.position.clone().sub(home).clampLength(0, farthest_m);
  const position = fromHome.add(home);
  position.y = Math.max(position.y, lowestEye_m);
  return position.distanceTo(view.position) < 1e-9 ? view : { ...view, position };
}
