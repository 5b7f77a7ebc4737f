// SPDX-License-Identifier: Apache-2.0
// How what stands before one sensor's background moves, by cells of its depth grid (roomcast/scene_flow).
import type { Intrinsics } from '../gen/control_pb';

/** Pixels of a cell, along each axis. */
export const flowCell_px = 4;
/** Of a cell: metres per second in the sensor's frame (x, y, z), and the depth in metres up to which surfaces move. */
export const flowChannels = 4;

/** A sensor's pictures and its lens, without distortion, which changes a motion by some percent. */
export type FlowLens = Pick<Intrinsics, 'width' | 'height' | 'fx' | 'fy' | 'cx' | 'cy'>;

/** In cells; the last of a row and of a column may be narrower than the others. */
export function flowSize({ width, height }: Pick<FlowLens, 'width' | 'height'>): { width: number; height: number } {
  return { width: Math.ceil(width / flowCell_px), height: Math.ceil(height / flowCell_px) };
}
