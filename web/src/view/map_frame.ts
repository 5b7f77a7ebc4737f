// SPDX-License-Identifier: Apache-2.0
// The part of the room that a map from above shows: all sensors, and what they look at. Metres; the world's x is to the
// right in the map, its z down. Pure.
import { median } from './view_limits';

const margin_m = 1;
const farthest_m = 40; // from the middle: a sensor at an absurd place does not shrink the room to a dot
const least_m = 4;
const aroundPerson_m = 0.4;
const besideRoom_m = 3; // how far the map is stretched for people

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

/** With the people as well, as far as they stand near the room; in whole metres, so that the map does not tremble. */
export function stretched(frame: MapFrame, people: readonly MapPoint[]): MapFrame {
  const near = people.map((point) => insideFrame(point, frame, -besideRoom_m));
  const xs = [frame.left, frame.left + frame.width, ...near.flatMap(({ x }) => [x - aroundPerson_m, x + aroundPerson_m])];
  const ys = [frame.top, frame.top + frame.height, ...near.flatMap(({ y }) => [y - aroundPerson_m, y + aroundPerson_m])];
  const [left, top] = [Math.floor(Math.min(...xs)), Math.floor(Math.min(...ys))];
  return { left, top, width: Math.ceil(Math.max(...xs)) - left, height: Math.ceil(Math.max(...ys)) - top };
}

/** The point, or the nearest one `edge` metres within the map's edge. */
export function insideFrame({ x, y }: MapPoint, { left, top, width, height }: MapFrame, edge = 0): MapPoint {
  const clamp = (value: number, low: number, size: number) =>
    Math.min(low + size - edge, Math.max(low + edge, value));
  return { x: clamp(x, left, width), y: clamp(y, top, height) };
}
