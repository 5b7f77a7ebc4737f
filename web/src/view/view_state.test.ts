// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import {
  between,
  direction,
  dolly,
  look,
  lookFrom,
  maxPitch,
  orbit,
  orientation,
  pan,
  pivot,
  viewFromMatrix,
  walk,
} from './view_state';

const start = lookFrom(new Vector3(1, 1.6, 3), new Vector3(0, 1, -1));

function expectClose(a: Vector3, b: Vector3): void {
  expect(a.distanceTo(b)).toBeLessThan(1e-9);
}

describe('a view', () => {
  test('looks at its target', () => {
    expectClose(pivot(start), new Vector3(0, 1, -1));
    expectClose(lookFrom(new Vector3(0, 0, 0), new Vector3(0, 0, -2)).position, new Vector3());
    expect(lookFrom(new Vector3(), new Vector3(-2, 0, 0)).yaw).toBeCloseTo(Math.PI / 2);
  });

  test('has an orientation that turns -z into its direction', () => {
    expectClose(new Vector3(0, 0, -1).applyQuaternion(orientation(start)), direction(start));
    expect(new Vector3(1, 0, 0).applyQuaternion(orientation(start)).y).toBeCloseTo(0);
  });

  test('straight down or at its own place still has an orientation', () => {
    for (const target of [new Vector3(1, 0, 3), new Vector3(1, 1.6, 3)]) {
      const view = lookFrom(new Vector3(1, 1.6, 3), target);
      expect(Math.abs(view.pitch)).toBeLessThanOrEqual(maxPitch);
      expect(Number.isFinite(view.yaw)).toBe(true);
    }
  });

  test('orbits around its pivot at the same distance', () => {
    const turned = orbit(start, 0.7, -0.2);
    expectClose(pivot(turned), pivot(start));
    expect(turned.position.distanceTo(pivot(start))).toBeCloseTo(start.distance);
    expect(turned.position.distanceTo(start.position)).toBeGreaterThan(1);
  });

  test('turns its head in place, never past straight up', () => {
    expectClose(look(start, 1, 0.1).position, start.position);
    expect(look(start, 0, 10).pitch).toBe(maxPitch);
  });

  test('pans across the line of sight', () => {
    const move = pan(start, 2, 1).position.sub(start.position);
    expect(move.dot(direction(start))).toBeCloseTo(0);
    expect(move.length()).toBeCloseTo(Math.sqrt(5));
  });

  test('zooms towards its pivot, and through it in the end', () => {
    const near = dolly(start, 0.5);
    expectClose(pivot(near), pivot(start));
    expect(near.distance).toBeCloseTo(start.distance / 2);
    let view = start;
    for (let i = 0; i < 60; i++) view = dolly(view, 0.8);
    expect(view.distance).toBeGreaterThan(0.2);
    expect(pivot(view).distanceTo(pivot(start))).toBeGreaterThan(0.5);
  });

  test('has others between itself and another one, turning the shorter way', () => {
    const a = { position: new Vector3(0, 1, 0), yaw: 3, pitch: 0, distance: 1 };
    const b = { position: new Vector3(2, 1, 0), yaw: -3, pitch: 0.4, distance: 3 };
    const middle = between(a, b, 0.5);
    expectClose(middle.position, new Vector3(1, 1, 0));
    expect(middle.yaw).toBeCloseTo(Math.PI);
    expect([middle.pitch, middle.distance]).toEqual([0.2, 2]);
    expectClose(direction(between(a, b, 1)), direction(b));
    expect(between(a, b, 0)).toEqual(a);
  });

  test('walks on the level even when it looks down', () => {
    const down = { ...start, yaw: 0, pitch: -1 };
    expectClose(walk(down, 2, 1, 0).position.sub(down.position), new Vector3(1, 0, -2));
    expectClose(walk(down, 0, 0, 0.5).position.sub(down.position), new Vector3(0, 0.5, 0));
  });

  test('is read from a pose matrix', () => {
    const view = viewFromMatrix([0, 0, 1, 2, 0, 1, 0, 1.6, -1, 0, 0, -3, 0, 0, 0, 1], 2);
    expectClose(view.position, new Vector3(2, 1.6, -3));
    expectClose(direction(view), new Vector3(-1, 0, 0));
  });
});
