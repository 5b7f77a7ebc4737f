// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { MarkKind } from '../gen/control_pb';
import type { Drawn } from './mark_scene';
import { MeasureTool, NoteTool } from './point_tools';
import { SketchTool } from './sketch_tool';
import type { ToolRoom } from './tool';

/** A wall at z = -2: a metre is 100 pixels; from x = 300 on there is nothing. */
function wall() {
  const at = (x: number, y: number) => (x < 300 ? new Vector3(x / 100, y / 100, -2) : undefined);
  const shown: { drafts: readonly Drawn[]; said: string; pictures: number } = { drafts: [], said: '', pictures: 0 };
  const room: ToolRoom & { viewStamp: string } = {
    pick: at,
    pickMany: () => (shown.pictures++, at),
    viewStamp: 'here',
    color: 0xe69f00,
    show: (drafts) => void (shown.drafts = drafts),
    say: (sentence) => void (shown.said = sentence),
  };
  return { room, shown };
}

test('a stroke is drawn while it is made, left when it ends, and needs one picture while the view stays', () => {
  const { room, shown } = wall();
  const left: number[][][] = [];
  const tool = new SketchTool(room, (sketches) => left.push(sketches));
  tool.press(100, 100);
  for (let x = 100; x <= 120; x += 5) tool.drag(x, 100);
  tool.update();
  expect(shown.drafts[0]).toMatchObject({ kind: MarkKind.SKETCH, colorRgb: 0xe69f00 });
  expect(shown.pictures).toBe(1);
  room.viewStamp = 'there';
  tool.drag(130, 100);
  expect(shown.pictures).toBe(2);
  tool.release();
  expect(left).toHaveLength(1);
  expect(left[0]![0]!.slice(0, 3)).toEqual([1, 1, -2]);
  expect(shown.drafts).toEqual([]);
});

test('a stroke beside all surfaces leaves nothing and says so, a cancelled one says nothing', () => {
  const { room, shown } = wall();
  const tool = new SketchTool(room, () => expect.fail('nothing was drawn'));
  tool.press(400, 100);
  tool.drag(450, 100);
  tool.release();
  expect(shown.said).toMatch(/no surface/);
  shown.said = '';
  tool.press(100, 100);
  tool.drag(150, 100);
  tool.cancel();
  tool.release();
  expect(shown).toMatchObject({ said: '', drafts: [] });
});

test('a distance has two ends, and the third press begins another one', () => {
  const { room, shown } = wall();
  const measured: number[] = [];
  const tool = new MeasureTool(room, (from, to) => measured.push(from.distanceTo(to)));
  const press = (x: number, y: number) => (tool.press(x, y), tool.release());
  press(100, 100);
  expect(measured).toEqual([]);
  press(220, 100);
  expect(measured[0]).toBeCloseTo(1.2);
  expect(shown.drafts[0]).toMatchObject({ kind: MarkKind.DISTANCE });
  press(500, 100);
  expect(shown.said).toMatch(/no surface/);
  press(100, 100);
  expect(shown.drafts[0]).toMatchObject({ kind: MarkKind.NOTE });
  press(100, 150);
  expect(measured[1]).toBeCloseTo(0.5);
});

test('a note is pinned where the finger is let go', () => {
  const { room, shown } = wall();
  let place: Vector3 | undefined;
  const tool = new NoteTool(room, (point) => (place = point), () => (place = undefined));
  tool.press(100, 100);
  tool.drag(120, 140);
  tool.release();
  expect(place!.toArray()).toEqual([1.2, 1.4, -2]);
  expect(shown.drafts).toHaveLength(1);
  tool.end();
  expect(place).toBeUndefined();
  expect(shown.drafts).toEqual([]);
});
