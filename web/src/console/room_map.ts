// SPDX-License-Identifier: Apache-2.0
// A map of the room from above: each sensor with its field of view as a wedge, a line between sensors that see the same
// surfaces, people, and a bar of a metre.
import { isDoubtful } from '../panel/placement_tag';
import type { RoomSensor } from '../room_roster';
import { consoleTexts as texts } from '../console_texts';
import { sensorColor } from '../view/sensor_color';
import { spotOf, wedge, type Spot } from '../panel/sensor_wedge';
import { svg } from '../panel/svg';
import type { Pair } from './pair_watch';

const margin_m = 0.7;
const goodGap_mm = 15;
const fairGap_mm = 35;

export function gapGrade(gap_mm: number): 'good' | 'fair' | 'poor' {
  if (gap_mm <= goodGap_mm) return 'good';
  return gap_mm <= fairGap_mm ? 'fair' : 'poor';
}

function label(text: string, x: number, y: number, className: string): SVGElement {
  const made = svg('text', { x, y, class: className, 'text-anchor': 'middle', 'font-size': 0.24 });
  made.textContent = text;
  return made;
}

function dot({ entry, x, y, heading }: Spot): SVGElement[] {
  const ring = { cx: x, cy: y, r: 0.13, fill: sensorColor(entry.id), 'stroke-width': 0.05 };
  const circle = svg('circle', { ...ring, 'data-sensor': entry.id, class: isDoubtful(entry.pose) ? 'doubtful' : 'placed', opacity: entry.online ? 1 : 0.4 });
  const behind = [x - 0.34 * Math.cos(heading), y - 0.34 * Math.sin(heading) + 0.08] as const;
  return [circle, label(entry.name, ...behind, 'name')];
}

function link(a: Spot, b: Spot, pair: Pair): SVGElement[] {
  const line = { x1: a.x, y1: a.y, x2: b.x, y2: b.y, 'stroke-width': 0.045 };
  const text = `${pair.gap_mm.toFixed(0)} mm`;
  return [
    svg('line', { ...line, class: `pair ${gapGrade(pair.gap_mm)}` }),
    label(text, (a.x + b.x) / 2, (a.y + b.y) / 2 - 0.08, 'gap'),
  ];
}

export interface MapPerson {
  x: number; // the world's x and z, metres
  z: number;
  color: string;
  name: string;
}

function person({ x, z, color, name }: MapPerson): SVGElement {
  const spot = svg('circle', { cx: x, cy: z, r: 0.1, fill: color, class: 'person' });
  const title = svg('title', {});
  title.textContent = name;
  spot.append(title);
  return spot;
}

function metre(left: number, bottom: number): SVGElement[] {
  const bar = svg('path', { class: 'scale', d: `M${left} ${bottom - 0.08}v0.08h1v-0.08`, 'stroke-width': 0.03 });
  return [bar, label('1 m', left + 0.5, bottom - 0.08, 'name')];
}

/** Replaces the content of `into`. */
export function drawMap(into: SVGElement, entries: readonly RoomSensor[], pairs: readonly Pair[], people: readonly MapPerson[]): void {
  const spots = entries.map(spotOf);
  const xs = [...spots, ...people].map(({ x }) => x);
  const ys = [...spots.map(({ y }) => y), ...people.map(({ z }) => z)];
  const left = Math.min(...xs) - margin_m;
  const top = Math.min(...ys) - margin_m;
  const width = Math.max(...xs) + margin_m - left;
  const height = Math.max(...ys) + margin_m - top;
  if (spots.length > 0) into.setAttribute('viewBox', `${left} ${top} ${width} ${height}`);
  into.setAttribute('aria-label', texts.mapLabel(entries.length));
  const spot = (id: number) => spots.find(({ entry }) => entry.id === id);
  const links = pairs.flatMap((pair) => {
    const [a, b] = [spot(pair.a), spot(pair.b)];
    return a && b ? link(a, b, pair) : [];
  });
  const scale = spots.length > 0 ? metre(left + 0.15, top + height - 0.12) : [];
  into.replaceChildren(...spots.map(wedge), ...links, ...people.map(person), ...spots.flatMap(dot), ...scale);
}
