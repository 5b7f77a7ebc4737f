// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { dolly, lookFrom, lowestEye_m, orbit, pan, pivot, walk, type ViewState } from './view_state';
import { most_m, reachAround, reachOf, withinReach } from './view_limits';

const sensorAt = (x: number, z: number) => ({ worldFromDepth: [1, 0, 0, x, 0, 1, 0, 1, 0, 0, 1, z, 0, 0, 0, 1] });
const start = lookFrom(new Vector3(1, 1.6, 3), new Vector3(0, 1, -1));

const reach = reachAround(start);
const farthest_m = reach.radius_m;

function repeated(times: number, view: ViewState, step: (view: ViewState) => ViewState): ViewState {
  for (let i = 0; i < times; i++) view = withinReach(step(view), reach);
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

  test('a view that is outside already is moved into it', () => {
    const outside = lookFrom(new Vector3(0, 1.6, 100), new Vector3(0, 1, 90));
    expect(withinReach(outside, reach).position.z).toBeLessThan(farthest_m);
    const under = lookFrom(new Vector3(0, -2, 3), new Vector3(0, 1, 0));
    expect(withinReach(under, reach).position.y).toBe(lowestEye_m);
  });

  test('the limit follows the size of the room', () => {
    expect(reachOf([])).toBeUndefined();
    const small = reachOf([sensorAt(0, 0), sensorAt(2, 0)])!;
    const hall = reachOf([sensorAt(-12, 0), sensorAt(12, 0), sensorAt(0, 20)])!;
    expect(small.radius_m).toBeGreaterThanOrEqual(10);
    expect(small.radius_m).toBeLessThan(20);
    expect(hall.radius_m).toBeGreaterThan(40);
    expect(hall.radius_m).toBeLessThanOrEqual(most_m);
    expect(small.centre.distanceTo(new Vector3(0, 1, 0))).toBeLessThan(3);
  });

  test('a sensor that says that it is miles away does not take the room along', () => {
    const { centre, radius_m } = reachOf([sensorAt(0, 0), sensorAt(2, 0), sensorAt(9000, 0)])!;
    expect(centre.length()).toBeLessThan(4);
    expect(radius_m).toBe(most_m);
  });
});
