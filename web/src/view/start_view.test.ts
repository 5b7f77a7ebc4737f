// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { SensorPose } from '../sensor_pose';
import { placedOrAll, startView } from './start_view';
import { direction } from './view_state';

/** A sensor at `position` that looks level at `target`. */
function sensor(position: [number, number, number], target: [number, number, number]) {
  const z = new Vector3(...target)
    .sub(new Vector3(...position))
    .setY(0)
    .normalize();
  const y = new Vector3(0, -1, 0);
  const x = y.clone().cross(z);
  const [px, py, pz] = position;
  return { worldFromDepth: [x.x, y.x, z.x, px, x.y, y.y, z.y, py, x.z, y.z, z.z, pz, 0, 0, 0, 1] };
}

describe('the start view', () => {
  test('needs a sensor', () => expect(startView([])).toBeUndefined());

  test('of one sensor has its direction, from eye height', () => {
    const view = startView([sensor([1, 1.2, 2], [1, 1.2, -2])])!;
    expect(view.position.y).toBeCloseTo(1.6);
    expect(direction(view).z).toBeLessThan(-0.9);
  });

  test('of sensors in an arc is on their side', () => {
    const view = startView([sensor([-2, 1.5, 2], [0, 1, 0]), sensor([2, 1.5, 2], [0, 1, 0])])!;
    expect(view.position.z).toBeGreaterThan(1);
    expect(direction(view).z).toBeLessThan(-0.8);
  });

  test('ignores unplaced sensors unless there are no others', () => {
    const unplaced: SensorPose = { worldFromDepth: [], source: 'none', state: 'none', expectedErrorMm: 0, note: '' };
    const placed: SensorPose = { ...unplaced, source: 'estimated', state: 'valid' };
    expect(placedOrAll([unplaced, placed])).toEqual([placed]);
    expect(placedOrAll([unplaced])).toEqual([unplaced]);
  });

  test('of sensors all around is at a distance and looks at the middle', () => {
    const ring = [
      [2, 2],
      [-2, 2],
      [-2, -2],
      [2, -2],
    ].map(([x, z]) => sensor([x!, 1.5, z!], [0, 1, 0]));
    const view = startView(ring)!;
    const middle = new Vector3(0, view.position.y, 0).sub(view.position);
    expect(middle.length()).toBeGreaterThan(1.5);
    expect(direction(view).setY(0).normalize().dot(middle.normalize())).toBeGreaterThan(0.9);
  });
});
