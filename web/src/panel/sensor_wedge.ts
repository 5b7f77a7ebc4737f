// SPDX-License-Identifier: Apache-2.0
// A sensor on a map of the room from above: where it stands, and what it looks at as a wedge. Metres; the world's x is to
// the right in the map, its z down.
import type { RoomSensor } from '../room_roster';
import { sensorColor } from '../view/sensor_color';
import { svg } from './svg';

const wedge_m = 1.6;

export interface Spot {
  entry: RoomSensor;
  x: number; // metres, to the right in the map
  y: number; // down in the map: the world's z
  heading: number; // radians, 0 to the right, clockwise as in SVG
}

export function spotOf(entry: RoomSensor): Spot {
  const m = entry.pose.worldFromDepth;
  return { entry, x: m[3]!, y: m[11]!, heading: Math.atan2(m[10]!, m[2]!) };
}

export function wedge({ entry, x, y, heading }: Spot): SVGElement {
  const { width, fx } = entry.calibration!.depth!;
  const half = Math.atan(width / 2 / fx);
  const corner = (angle: number) =>
    `${(x + wedge_m * Math.cos(angle)).toFixed(3)} ${(y + wedge_m * Math.sin(angle)).toFixed(3)}`;
  const color = sensorColor(entry.id);
  const d = `M${x} ${y}L${corner(heading - half)}A${wedge_m} ${wedge_m} 0 0 1 ${corner(heading + half)}Z`;
  return svg('path', {
    d,
    fill: color,
    'fill-opacity': entry.online ? 0.16 : 0.05,
    stroke: color,
    'stroke-width': 0.02,
  });
}
