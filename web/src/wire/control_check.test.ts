// SPDX-License-Identifier: Apache-2.0
import { create, type MessageInitShape } from '@bufbuild/protobuf';
import { describe, expect, test } from 'vitest';
import { ControlSchema, MarkKind } from '../gen/control_pb';
import { checkControl, checkRigid } from './control_check';
import { WireError } from './wire_error';

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const camera = { width: 512, height: 424, fx: 365, fy: 365, cx: 256, cy: 212 };
const sensor = {
  id: 1,
  name: 's0',
  fps: 30,
  worldFromDepth: identity,
  calibration: { depth: camera, color: camera, colorFromDepth: identity },
};

type Message = MessageInitShape<typeof ControlSchema>['message'];

function refusal(message: Message): string | undefined {
  try {
    checkControl(create(ControlSchema, { message: message! }));
    return undefined;
  } catch (error) {
    if (error instanceof WireError) return error.message;
    throw error;
  }
}

function refusalOfSensor(change: object): string | undefined {
  return refusal({ case: 'roster', value: { fps: 30, sensors: [{ ...sensor, ...change }] } });
}

function refusalOfDepthCamera(change: object): string | undefined {
  return refusalOfSensor({ calibration: { ...sensor.calibration, depth: { ...camera, ...change } } });
}

function refusalOfHead(change: object): string | undefined {
  const head = { x: 0, y: 1.6, z: 0, qx: 0, qy: 0, qz: 0, qw: 1, ...change };
  return refusal({ case: 'viewerPoses', value: { poses: [{ viewerId: 1, head }] } });
}

describe('a roster', () => {
  test('that is right is accepted', () => {
    expect(refusalOfSensor({})).toBeUndefined();
  });
  test('with a sensor without calibration is refused', () => {
    expect(refusalOfSensor({ calibration: {} })).toMatch(/depth pictures/);
  });
  test('with a depth grid that is too small or too large is refused', () => {
    expect(refusalOfDepthCamera({ width: 15 })).toMatch(/16 to 4096/);
    expect(refusalOfDepthCamera({ height: 4097 })).toMatch(/16 to 4096/);
    expect(refusalOfDepthCamera({ width: 4096, height: 16 })).toBeUndefined();
  });
  test('with intrinsics that are not numbers is refused', () => {
    expect(refusalOfDepthCamera({ fx: 0 })).toMatch(/focal/);
    expect(refusalOfDepthCamera({ cx: NaN })).toMatch(/finite/);
  });
  test('with a frame rate of 0, NaN or 241 is refused', () => {
    for (const fps of [0, NaN, 241, -1]) expect(refusalOfSensor({ fps })).toMatch(/frame rate/);
  });
  test('with an id of more than 16 bits is refused', () => {
    expect(refusalOfSensor({ id: 65536 })).toMatch(/16 bits/);
  });
  test('with a pose that is missing is refused', () => {
    expect(refusalOfSensor({ worldFromDepth: [] })).toMatch(/16 numbers/);
  });
  test('with a name that is too long or has control characters is refused', () => {
    expect(refusalOfSensor({ name: 'é'.repeat(33) })).toMatch(/longer than 64 bytes/);
    expect(refusalOfSensor({ name: 'é'.repeat(32) })).toBeUndefined();
    expect(refusalOfSensor({ name: 'a\u0007' })).toMatch(/control characters/);
    expect(refusalOfSensor({ name: 'a\u0085' })).toMatch(/control characters/);
  });
  test('of more sensors or viewers than a room may have is refused', () => {
    const sensors = Array.from({ length: 33 }, () => sensor);
    const viewers = Array.from({ length: 2049 }, () => ({ id: 1, name: '' }));
    expect(refusal({ case: 'roster', value: { sensors } })).toMatch(/more sensors/);
    expect(refusal({ case: 'roster', value: { viewers } })).toMatch(/more sensors or viewers/);
  });
});

describe('a rigid transform', () => {
  const withNumber = (at: number, value: number) => identity.map((n, i) => (i === at ? value : n));
  test('that scales, shears or mirrors is refused', () => {
    expect(() => checkRigid(withNumber(0, 1.1), 'it')).toThrow(/rotation/);
    expect(() => checkRigid(withNumber(1, 0.5), 'it')).toThrow(/rotation/);
    expect(() => checkRigid(withNumber(0, -1), 'it')).toThrow(/mirror/);
  });
  test('with numbers out of range or a wrong last row is refused', () => {
    expect(() => checkRigid(withNumber(3, 1e5), 'it')).toThrow(/out of range/);
    expect(() => checkRigid(withNumber(3, NaN), 'it')).toThrow(/out of range/);
    expect(() => checkRigid(withNumber(12, 1), 'it')).toThrow(/last row|end with/);
  });
  test('with a translation is accepted', () => {
    expect(() => checkRigid(withNumber(3, -12.5), 'it')).not.toThrow();
  });
});

describe("a viewer's pose", () => {
  test('that is right is accepted', () => expect(refusalOfHead({})).toBeUndefined());
  test('that is out of range is refused', () => {
    expect(refusalOfHead({ x: 1e5 })).toMatch(/range/);
    expect(refusalOfHead({ z: NaN })).toMatch(/range/);
  });
  test('with a quaternion of another length than 1 is refused', () => {
    expect(refusalOfHead({ qw: 0.9 })).toMatch(/unit length/);
    expect(refusalOfHead({ qw: NaN })).toMatch(/unit length/);
  });
  test('that points out of the world is refused', () => {
    const pointing = (x: number) =>
      refusal({
        case: 'viewerPoses',
        value: { poses: [{ viewerId: 1, head: { qw: 1 }, pointer: { to: { x } } }] },
      });
    expect(pointing(3)).toBeUndefined();
    expect(pointing(1e5)).toMatch(/range/);
  });
  test('without a head is refused', () => {
    expect(refusal({ case: 'viewerPoses', value: { poses: [{ viewerId: 1 }] } })).toMatch(/head/);
  });
});

test('a welcome may leave the start pose out, but not give a wrong one', () => {
  expect(refusal({ case: 'welcome', value: { room: 'lab' } })).toBeUndefined();
  expect(refusal({ case: 'welcome', value: { startPose: [1, 2, 3] } })).toMatch(/start_pose/);
});

describe('marks', () => {
  const note = { kind: MarkKind.NOTE, points: [1, 0, -2], text: 'mind the step' };
  const refusalOfMark = (change: object) => refusal({ case: 'marks', value: { marks: [{ ...note, ...change }] } });
  test('that are right are accepted, and those of a kind of a later version, too', () => {
    expect(refusalOfMark({})).toBeUndefined();
    expect(refusalOfMark({ kind: MarkKind.SKETCH, points: [0, 0, 0, 1, 1, 1], text: '' })).toBeUndefined();
    expect(refusalOfMark({ kind: 99, points: [1, 2, 3] })).toBeUndefined();
  });
  test('with other points than their kind has are refused', () => {
    expect(refusalOfMark({ points: [1, 2] })).toMatch(/number of points/);
    expect(refusalOfMark({ points: [1, 2, 3, 4, 5, 6] })).toMatch(/number of points/);
    expect(refusalOfMark({ kind: MarkKind.SKETCH, points: Array(3 * 513).fill(0) })).toMatch(/number of points/);
    expect(refusalOfMark({ kind: 99, points: Array(3e6).fill(0) })).toMatch(/number of points/);
    expect(refusalOfMark({ points: [NaN, 0, 0] })).toMatch(/range/);
  });
  test('with too many words, or too many of them, are refused', () => {
    expect(refusalOfMark({ text: 'é'.repeat(141) })).toMatch(/longer than 280/);
    expect(refusalOfMark({ text: 'two\nlines' })).toMatch(/control/);
    expect(refusal({ case: 'marks', value: { marks: Array(501).fill(note) } })).toMatch(/more marks/);
  });
});
