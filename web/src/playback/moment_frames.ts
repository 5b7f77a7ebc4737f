// SPDX-License-Identifier: Apache-2.0
// The order in which the frames of a moment are decoded, so that something is seen at once: first the oldest frame of each
// sensor, which is a key frame, as one frame set; then all others, of which only the last of each sensor is shown, as
// another set. Pure.
import type { FrameHeader } from '../wire/frame_header';

export interface MomentFrame {
  header: FrameHeader;
  payload: Uint8Array;
  isShown: boolean;
}

/** `frames` in order of time; `setId` and the next one are free for the two sets. */
export function inOrderOfShowing(frames: readonly Omit<MomentFrame, 'isShown'>[], setId: bigint): MomentFrame[] {
  const first = new Map<number, MomentFrame>();
  const last = new Map<number, MomentFrame>();
  const between: MomentFrame[] = [];
  for (const { header, payload } of frames) {
    const frame = { header, payload, isShown: false };
    if (!first.has(header.sensor)) {
      first.set(header.sensor, frame);
      continue;
    }
    const before = last.get(header.sensor);
    if (before) between.push(before);
    last.set(header.sensor, frame);
  }
  return [...asSet([...first.values()], setId), ...between, ...asSet([...last.values()], setId + 1n)];
}

function asSet(frames: readonly MomentFrame[], setId: bigint): MomentFrame[] {
  return frames.map(({ header, payload }, i) => {
    return { header: { ...header, setId, last: i === frames.length - 1 }, payload, isShown: true };
  });
}
