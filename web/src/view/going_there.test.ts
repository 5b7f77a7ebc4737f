// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { floorPoint, Glide, viewAt } from './going_there';
import { direction, lookFrom, pivot } from './view_state';

const view = lookFrom(new Vector3(0, 1.6, 3), new Vector3(0, 1, -1));

describe('going to a point', () => {
  test('of a wall ends a metre in front of it, at the same height, looking at it', () => {
    const wall = new Vector3(2, 1.2, -3);
    const there = viewAt(view, wall);
    expect(there.position.y).toBe(1.6);
    expect(Math.hypot(there.position.x - wall.x, there.position.z - wall.z)).toBeCloseTo(1);
    expect(there.position.distanceTo(view.position)).toBeGreaterThan(4);
    expect(pivot(there).distanceTo(wall)).toBeLessThan(1e-9);
  });

  test('that is nearer than that turns the head only', () => {
    const there = viewAt(view, new Vector3(0.5, 1, 2.6));
    expect(there.position.distanceTo(view.position)).toBeLessThan(1e-9);
    expect(direction(there).dot(new Vector3(0.5, -0.6, -0.4).normalize())).toBeCloseTo(1);
    expect(Number.isFinite(viewAt(view, new Vector3(0, 1, 3)).yaw)).toBe(true);
  });

  test('of the floor ends on it, with the eyes up', () => {
    const down = { ...view, pitch: -1.2 };
    const there = viewAt(down, new Vector3(1, 0.02, -1));
    expect(there.position).toEqual(new Vector3(1, 1.6, -1));
    expect(there.yaw).toBe(down.yaw);
    expect(there.pitch).toBeGreaterThan(-0.4);
  });

  test('is also possible where no sensor sees the floor, unless that is too far away', () => {
    const ray = new Vector3(0, -0.8, -1);
    expect(floorPoint(view.position, ray, 20)!.distanceTo(new Vector3(0, 0, 1))).toBeLessThan(1e-9);
    expect(floorPoint(view.position, new Vector3(0, 0.1, -1), 20)).toBeUndefined();
    expect(floorPoint(view.position, new Vector3(0, -0.01, -1), 20)).toBeUndefined();
  });
});

test('the way there begins and ends gently, and arrives exactly', () => {
  const to = lookFrom(new Vector3(3, 1.6, 3), new Vector3(3, 1, 0));
  const glide = new Glide(view, to);
  const way = [0, 50, 270, 490, 540].map((ms) => glide.at(1000 + ms));
  expect(way[0]!.view.position.distanceTo(view.position)).toBeLessThan(1e-9);
  expect(way[1]!.view.position.x).toBeLessThan(0.1);
  expect(way[2]!.view.position.x).toBeCloseTo(1.5);
  expect(way[3]!.view.position.x).toBeGreaterThan(2.9);
  expect(way.map(({ isOver }) => isOver)).toEqual([false, false, false, false, true]);
  expect(way[4]!.view).toBe(to);
});
