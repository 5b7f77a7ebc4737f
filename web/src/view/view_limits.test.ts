// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { dolly, lookFrom, lowestEye_m, orbit, pan, pivot, walk, type ViewState } from './view_state';
import { farthest_m, withinReach } from './view_limits';

const start = lookFrom(new Vector3(1, 1.6, 3), new Vector3(0, 1, -1));

function repeated(times: number, view: ViewState, step: (view: ViewState) => ViewState): ViewState {
  for (let i = 0; i < times; i++) view = withinReach(step(view), pivot(start));
  return view;
}

describe('the viewer stays where there is something to see', () => {
  test('an orbit goes no lower than the floor, and keeps its pivot', () => {
    const low = repeated(30, start, (view) => orbit(view, 0.01, 0.06));
    expect(low.position.y).toBeGreaterThanOrEqual(lowestEye_m - 1e-9);
    expect(low.position.y).toBeLessThan(lowestEye_m + 0.1);
    expect(pivot(low).distanceTo(pivot(start))).toBeLessThan(1e-6);
    expect(repeated(10, low, (view) => orbit(view, 0, -0.06)).position.y).toBeGreaterThan(1);
  });

  test('the wheel ends where the room is still in view, and comes back', () => {
    const far = repeated(25, start, (view) => dolly(view, Math.exp(0.12)));
    expect(far.position.distanceTo(pivot(start))).toBeLessThanOrEqual(farthest_m + 1e-9);
    expect(pivot(far).distanceTo(pivot(start))).toBeLessThan(1e-6);
    expect(repeated(3, far, (view) => dolly(view, Math.exp(-0.12))).distance).toBeLessThan(far.distance - 1);
  });

  test('walking, shifting and zooming through the pivot end in reach, above the floor', () => {
    const steps: ((view: ViewState) => ViewState)[] = [
      (view) => walk(view, 2, 0, -0.5),
      (view) => pan(view, 3, 0),
      (view) => dolly(view, 0.5),
      (view) => walk(view, 0, 0, 5),
    ];
    for (const step of steps) {
      const { position } = repeated(100, start, step);
      expect(position.distanceTo(pivot(start))).toBeLessThanOrEqual(farthest_m + 1e-6);
      expect(position.y).toBeGreaterThanOrEqual(lowestEye_m);
    }
  });

  test('a view that is outside already may only come nearer', () => {
    const outside = lookFrom(new Vector3(0, 1.6, 100), new Vector3(0, 1, 90));
    expect(withinReach(outside, pivot(start)).position.z).toBeLessThan(farthest_m);
    const under = lookFrom(new Vector3(0, -2, 3), new Vector3(0, 1, 0));
    expect(withinReach(under, pivot(start)).position.y).toBe(lowestEye_m);
  });
});
