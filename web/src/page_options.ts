// SPDX-License-Identifier: Apache-2.0
// Parses the options in the page's URL: ?mode=blend|mesh|points &at=x,y,z &look=x,y,z &panel=0 &name=... &room=...
// &quality=best &record=1. The credential is after the #: access.ts.
import { Vector3 } from 'three';
import { drawModes, type DrawMode } from './view/draw_mode';
import { lookFrom, type ViewState } from './view/view_state';
import { asName } from './wire/name_check';

export interface PageOptions {
  mode: DrawMode;
  view: ViewState | undefined; // start view, if the URL contains one
  panelOpen: boolean | undefined; // undefined: depends on the available space
  name: string;
  room: string;
  best: boolean; // draw at the finest quality, however slow: for pictures
  record: boolean; // keep a record of decoded frames, for tests
}

/** "1,2.5,-3" in metres; undefined for anything else. */
export function parsePoint(text: string | null): Vector3 | undefined {
  const numbers = text?.split(',').map((part) => (part.trim() === '' ? NaN : Number(part))) ?? [];
  if (numbers.length !== 3 || !numbers.every(Number.isFinite)) return undefined;
  return new Vector3(...(numbers as [number, number, number]));
}

export function parseOptions(search: string): PageOptions {
  const given = new URLSearchParams(search);
  const at = parsePoint(given.get('at'));
  const look = parsePoint(given.get('look')) ?? new Vector3(0, 1, 0);
  return {
    mode: drawModes.find((mode) => mode === given.get('mode')) ?? 'blend',
    view: at && lookFrom(at, look),
    panelOpen: given.has('panel') ? given.get('panel') !== '0' : undefined,
    name: asName(given.get('name') ?? ''),
    room: asName(given.get('room') ?? ''),
    best: given.get('quality') === 'best',
    record: given.get('record') === '1',
  };
}

/** The socket of the hub that served this page: page and socket share one port. */
export function socketUrl(page: Pick<Location, 'protocol' | 'host'>): string {
  return `${page.protocol === 'https:' ? 'wss' : 'ws'}://${page.host}/ws`;
}
