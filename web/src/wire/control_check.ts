// SPDX-License-Identifier: Apache-2.0
// Checks control messages from a hub to a viewer: docs/spec/wire.md §3 and §4; the same rules as
// roomcast/wire/control_check.cpp. Throws WireError.
import {
  MarkKind,
  type Calibration,
  type Control,
  type Intrinsics,
  type Mark,
  type Marks,
  type Pose,
  type Roster,
  type ViewerPose,
  type ViewerPoses,
  type Voices,
  type Welcome,
} from '../gen/control_pb';
import {
  maxDepthSide,
  maxFps,
  maxImageSide,
  maxMarkPoints,
  maxMarks,
  maxMarkTextBytes,
  maxPosesPerMessage,
  maxPosition_m,
  maxSensors,
  maxViewers,
  minDepthSide,
} from './limits';
import { checkName, checkText } from './name_check';
import { malformed, tooLarge } from './wire_error';

const rigidTolerance = 2e-3; // a millimetre and a milliradian of rounding; scaling and mirroring are more
const unitQuaternionTolerance = 0.01;
const maxSensorId = 0xffff;

function checkFps(fps: number): void {
  if (!(fps > 0 && fps <= maxFps)) throw malformed(`a frame rate must be above 0 and at most ${maxFps} per second`);
}

/** Row-major 4x4. */
export function checkRigid(m: readonly number[], what: string): void {
  if (m.length !== 16) throw malformed(`${what} must have 16 numbers`);
  if (!m.every((n) => Math.abs(n) <= maxPosition_m)) throw malformed(`${what} has a number out of range`);
  if (m[12] !== 0 || m[13] !== 0 || m[14] !== 0 || m[15] !== 1) {
    throw malformed(`${what} must end with the row 0 0 0 1`);
  }
  const at = (row: number, column: number) => m[4 * row + column]!;
  const dot = (a: number, b: number) => at(0, a) * at(0, b) + at(1, a) * at(1, b) + at(2, a) * at(2, b);
  for (let a = 0; a < 3; a++) {
    for (let b = a; b < 3; b++) {
      if (Math.abs(dot(a, b) - (a === b ? 1 : 0)) > rigidTolerance) {
        throw malformed(`${what} must be a rotation and a translation`);
      }
    }
  }
  const minor = (a: number, b: number) => at(1, a) * at(2, b) - at(1, b) * at(2, a);
  const determinant = at(0, 0) * minor(1, 2) - at(0, 1) * minor(0, 2) + at(0, 2) * minor(0, 1);
  if (determinant < 0) throw malformed(`${what} must not mirror`);
}

function checkIntrinsics(camera: Intrinsics | undefined, minSide: number, maxSide: number, what: string): void {
  const sideOk = (side: number) => side >= minSide && side <= maxSide;
  if (!camera || !sideOk(camera.width) || !sideOk(camera.height)) {
    throw malformed(`${what} pictures are ${minSide} to ${maxSide} pixels wide and high`);
  }
  const { fx, fy, cx, cy, k1, k2, k3, p1, p2 } = camera;
  if (![fx, fy, cx, cy, k1, k2, k3, p1, p2].every(Number.isFinite) || fx <= 0 || fy <= 0) {
    throw malformed(`${what} intrinsics need positive focal lengths and finite numbers`);
  }
}

function checkCalibration(calibration: Calibration | undefined): void {
  checkIntrinsics(calibration?.depth, minDepthSide, maxDepthSide, 'depth');
  checkIntrinsics(calibration?.color, 1, maxImageSide, 'colour');
  checkRigid(calibration?.colorFromDepth ?? [], 'color_from_depth');
}

function checkRoster(roster: Roster): void {
  if (roster.sensors.length > maxSensors || roster.viewers.length > maxViewers) {
    throw tooLarge('a roster lists more sensors or viewers than a room may have');
  }
  for (const sensor of roster.sensors) {
    if (sensor.id > maxSensorId) throw malformed("a sensor's ID must have at most 16 bits");
    checkName(sensor.name, 'sensor');
    checkCalibration(sensor.calibration);
    checkRigid(sensor.worldFromDepth, 'world_from_depth');
    checkFps(sensor.fps);
  }
  for (const viewer of roster.viewers) checkName(viewer.name, 'viewer');
}

function checkWelcome(welcome: Welcome): void {
  if (welcome.startPose.length > 0) checkRigid(welcome.startPose, 'start_pose');
}

function isWithinReach(place: { x: number; y: number; z: number }): boolean {
  return [place.x, place.y, place.z].every((metres) => Math.abs(metres) <= maxPosition_m);
}

function checkPose(pose: Pose): void {
  if (!isWithinReach(pose)) throw malformed('a pose is out of range');
  const norm2 = pose.qx ** 2 + pose.qy ** 2 + pose.qz ** 2 + pose.qw ** 2;
  if (!(Math.abs(norm2 - 1) < unitQuaternionTolerance)) {
    throw malformed("a pose's quaternion must have unit length");
  }
}

function checkViewerPose(pose: ViewerPose): void {
  if (!pose.head) throw malformed("a viewer's pose needs a head");
  for (const part of [pose.head, pose.leftHand, pose.rightHand]) {
    if (part) checkPose(part);
  }
  for (const end of [pose.pointer?.from, pose.pointer?.to]) {
    if (end && !isWithinReach(end)) throw malformed("a pointer's beam is out of range");
  }
}

function checkViewerPoses(message: ViewerPoses): void {
  if (message.poses.length > maxPosesPerMessage) throw tooLarge('there are more poses than a message may have');
  message.poses.forEach(checkViewerPose);
}

function checkVoices({ speaking, muted }: Voices): void {
  if (speaking.length > maxViewers || muted.length > maxViewers) throw tooLarge('there are more voices than viewers in a room');
}

/** Points, as the kind has them: at least, at most. A kind of a later version has any number, and is not shown. */
const pointsOf: Record<number, [number, number]> = {
  [MarkKind.NOTE]: [1, 1],
  [MarkKind.SKETCH]: [2, maxMarkPoints],
  [MarkKind.DISTANCE]: [2, 2],
  [MarkKind.PLACE]: [2, 2],
};

function checkMark({ kind, points, text, author }: Mark): void {
  const [least, most] = pointsOf[kind] ?? [0, maxMarkPoints];
  if (points.length > 3 * most || points.length < 3 * least || points.length % 3 !== 0) {
    throw malformed('a mark has the wrong number of points for its kind');
  }
  if (!points.every((metres) => Math.abs(metres) <= maxPosition_m)) throw malformed('a mark is out of range');
  checkText(text, maxMarkTextBytes, 'a note');
  checkName(author, 'author');
}

function checkMarks({ marks, removed }: Marks): void {
  if (marks.length > maxMarks || removed.length > maxMarks) throw tooLarge('there are more marks than a room may have');
  marks.forEach(checkMark);
}

export function checkControl(control: Control): void {
  switch (control.message.case) {
    case 'welcome':
      return checkWelcome(control.message.value);
    case 'roster':
      return checkRoster(control.message.value);
    case 'viewerPoses':
      return checkViewerPoses(control.message.value);
    case 'voices':
      return checkVoices(control.message.value);
    case 'marks':
      return checkMarks(control.message.value);
    default: // the other kinds have no invalid values, or a viewer does not use them
  }
}
