// SPDX-License-Identifier: Apache-2.0
// The room from above in the panel: sensors, people and oneself; a click goes there. It repeats what the picture and the
// lists say, and every place is reached by keys, too.
import type { Pose } from '../gen/control_pb';
import type { RoomState } from '../room_state';
import { mapTexts as texts } from '../texts';
import { insideFrame, mapFrame, stretched, type MapFrame, type MapPoint } from '../view/map_frame';
import { sensorColor } from '../view/sensor_color';
import { direction, viewFromBody, type ViewState } from '../view/view_state';
import { nameOf } from './people_list';
import { spotOf, wedge, type Spot } from './sensor_wedge';
import { svg } from './svg';
import { element } from './element';

const reach_m = 2.5; // of what a sensor looks at, to about the middle of the room
const bodyShare = 0.028; // size of a person, of the map's width

interface Person {
  name: string;
  color: string;
  view: Pick<ViewState, 'position' | 'yaw' | 'pitch'>;
}

export class MiniMap {
  private readonly map = svg('svg', { class: 'map', role: 'img', 'aria-label': texts.title }) as SVGSVGElement;
  readonly root = element('div', { class: 'mini-map' }, this.map);
  private frame: MapFrame | undefined;
  private drawn = '';

  /** `goTo` is called with the world's x and z, metres. */
  constructor(
    private readonly state: RoomState,
    private readonly goTo: (x: number, z: number) => void,
  ) {
    this.map.addEventListener('click', (event) => this.clicked(event));
  }

  /** `self` is this page's view. Draws only what has changed, and only when visible. */
  show(self: ViewState): void {
    const entries = this.state.roster?.sensors ?? [];
    const spots = entries.map(spotOf);
    const room = mapFrame(spots.flatMap(({ x, y, heading }) => [{ x, y }, ahead({ x, y }, heading)]));
    if (!room || !this.root.checkVisibility()) return;
    const people = this.people();
    const frame = stretched(room, [...people.map(({ view }) => view), self].map(standing));
    this.frame = frame;
    const size = bodyShare * frame.width;
    this.draw(frame, texts.label(entries.length, people.length), [
      ...spots.map(wedge),
      ...spots.map((spot) => camera(spot, size)),
      ...people.map((person) => body(person, frame, size, 'person')),
      body({ name: texts.you, color: 'currentColor', view: self }, frame, size, 'self'),
    ]);
  }

  private draw({ left, top, width, height }: MapFrame, label: string, parts: SVGElement[]): void {
    const viewBox = `${left} ${top} ${width} ${height}`;
    const drawing = [viewBox, label, ...parts.map(({ outerHTML }) => outerHTML)].join('');
    if (drawing === this.drawn) return;
    this.drawn = drawing;
    this.map.setAttribute('viewBox', viewBox);
    this.map.setAttribute('aria-label', label);
    this.map.replaceChildren(...parts);
  }

  private people(): Person[] {
    const self = this.state.welcome?.viewerId;
    return (this.state.roster?.viewers ?? []).flatMap((viewer) => {
      const head: Pose | undefined = this.state.poses.get(viewer.id)?.head;
      if (!head || viewer.relays || viewer.id === self) return [];
      const color = `#${viewer.colorRgb.toString(16).padStart(6, '0')}`;
      return [{ name: nameOf(viewer), color, view: viewFromBody(head, 1) }];
    });
  }

  private clicked({ clientX, clientY }: MouseEvent): void {
    const toScreen = this.map.getScreenCTM();
    if (!toScreen || !this.frame) return;
    const { x, y } = insideFrame(new DOMPoint(clientX, clientY).matrixTransform(toScreen.inverse()), this.frame);
    this.goTo(x, y);
  }
}

function standing({ position }: Pick<ViewState, 'position'>): MapPoint {
  return { x: position.x, y: position.z };
}

function ahead({ x, y }: MapPoint, heading: number): MapPoint {
  return { x: x + reach_m * Math.cos(heading), y: y + reach_m * Math.sin(heading) };
}

function camera({ entry, x, y }: Spot, size: number): SVGElement {
  return named(svg('circle', { cx: x, cy: y, r: size / 2, fill: sensorColor(entry.id) }), entry.name);
}

/** A drop whose tip points where the person looks. */
function body({ name, color, view }: Person, frame: MapFrame, size: number, className: string): SVGElement {
  const { x, y } = insideFrame(standing(view), frame, size);
  const gaze = direction({ yaw: view.yaw, pitch: 0 });
  const turn = (Math.atan2(gaze.z, gaze.x) * 180) / Math.PI;
  const drop = svg('path', {
    class: className,
    d: 'M2 0L0.6 -0.9A1 1 0 1 0 0.6 0.9Z',
    fill: color,
    transform: `translate(${x.toFixed(2)} ${y.toFixed(2)}) rotate(${turn.toFixed(0)}) scale(${size.toFixed(3)})`,
  });
  return named(drop, name);
}

/** With the name as a tooltip. */
function named(shape: SVGElement, name: string): SVGElement {
  const title = svg('title', {});
  title.textContent = name;
  shape.append(title);
  return shape;
}
