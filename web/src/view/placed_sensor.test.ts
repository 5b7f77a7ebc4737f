// SPDX-License-Identifier: Apache-2.0
import { create } from '@bufbuild/protobuf';
import { expect, test } from 'vitest';
import { Placement, RosterSchema } from '../gen/control_pb';
import { roomRoster } from '../room_roster';
import { PlacedSensor } from './placed_sensor';

function sensor(placement: Placement): PlacedSensor {
  const depth = { width: 4, height: 3, fx: 4, fy: 4, cx: 1.5, cy: 1 };
  const roster = roomRoster(create(RosterSchema, { sensors: [{ calibration: { depth }, placement }] }));
  const placed = new PlacedSensor(roster.sensors[0]!, true);
  placed.pictures.hasPicture = true;
  return placed;
}

test('an unplaced sensor is drawn alone while the others are blended', () => {
  const lost = sensor(Placement.UNPLACED);
  lost.updateVisible('mixed');
  expect(lost.surface.root.visible).toBe(true);
  expect(lost.layers.map((layer) => layer.nearest.visible || layer.mixed.visible)).toEqual([false, false, false]);

  const found = sensor(Placement.ALIGNED);
  found.updateVisible('mixed');
  expect(found.surface.root.visible).toBe(false);
  expect(found.layers.some((layer) => layer.nearest.visible)).toBe(true);
});
