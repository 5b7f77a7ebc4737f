// SPDX-License-Identifier: Apache-2.0
// The part of the room that a map from above shows: all sensors, and what they look at. Metres; the world's x is to the
// right in the map, its z down. Pure.
import { median } from './view_limits';

const margin_m = 1;
const farthest_m = 40; // from the middle: a sensor at an absurd place does not shrink the room to a dot
const least_m = 4;

export interface MapFrame {
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface MapPoint {
  x: number;
  y: number;
}

/** Undefined without points. */
export function mapFrame(points: readonly MapPoint[]): MapFrame | undefined {
  if (points.length === 0) return undefined;
  const range = (values: number[]) => {
    const middle = median(values);
    const near = values.filter((value) => Math.abs(value - middle) <= farthest_m);
    const [low, high] = [Math.min(...near) - margin_m, Math.max(...near) + margin_m];
    const missing = Math.max(0, least_m - (high - low));
    return { from: low - missing / 2, size: high - low + missing };
  };
  const [across, down] = [range(points.map(({ x }) => x)), range(points.map(({ y }) => y))];
  return { left: across.from, top: down.from, width: across.size, height: down.size };
}

/** The point, or the nearest one at the map's edge. */
export function insideFrame({ x, y }: MapPoint, { left, top, width, height }: MapFrame, edge = 0): MapPoint {
  const clamp = (value: number, low: number, size: number) =>
    Math.min(low + size - edge, Math.max(low + edge, value));
  return { x: clamp(x, left, width), y: clamp(y, top, height) };
}
