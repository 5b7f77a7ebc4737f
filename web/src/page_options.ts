// SPDX-License-Identifier: Apache-2.0
// Parses the options in the page's URL: ?mode=blend|mesh|points|still &at=x,y,z &look=x,y,z &panel=0 &name=... &room=...
// &quality=best &play=recording &from=seconds &study=1 &record=1 &controls=none &muted=1 &place=name. After the # are the credential (access.ts) and a shared viewpoint (view/view_address.ts), which
// takes precedence.
import { Vector3 } from 'three';
import { parsePoint } from './point';
import { drawModes, type DrawMode } from './view/draw_mode';
import { viewpointOf } from './view/view_address';
import { lookFrom, type ViewState } from './view/view_state';
import { asName } from './wire/name_check';

export interface PageOptions {
  mode: DrawMode;
  view: ViewState | undefined; // start view, if the URL contains one
  panelOpen: boolean | undefined; // undefined: depends on the available space
  name: string;
  room: string;
  best: boolean; // draw at the finest quality, however slow: for pictures
  playback: { recording: string; from_s: number } | undefined; // of the room, instead of its live picture
  study: boolean; // as a participant of the study that the hub runs
  controls: boolean; // show panel, tools and hints
  muted: boolean; // hear nobody
  place: string; // that somebody has named for everybody, to start at
  record: boolean; // keep a record of decoded frames, for tests
}

export function parseOptions(search: string, hash = ''): PageOptions {
  const given = new URLSearchParams(search);
  const at = parsePoint(given.get('at'));
  const look = parsePoint(given.get('look')) ?? new Vector3(0, 1, 0);
  const shared = viewpointOf(hash);
  return {
    mode: shared?.mode ?? drawModes.find((mode) => mode === given.get('mode')) ?? 'blend',
    view: shared?.view ?? (at && lookFrom(at, look)),
    panelOpen: given.has('panel') ? given.get('panel') !== '0' : undefined,
    name: asName(given.get('name') ?? ''),
    room: asName(given.get('room') ?? ''),
    best: given.get('quality') === 'best',
    playback: playbackOf(given),
    study: given.get('study') === '1',
    controls: given.get('controls') !== 'none',
    muted: given.get('muted') === '1',
    place: asName(given.get('place') ?? ''),
    record: given.get('record') === '1',
  };
}

function playbackOf(given: URLSearchParams): PageOptions['playback'] {
  const recording = given.get('play') ?? '';
  const from_s = Number(given.get('from') ?? 0);
  return recording === '' ? undefined : { recording, from_s: Number.isFinite(from_s) ? Math.max(0, from_s) : 0 };
}

/** The socket of the hub that served this page: page and socket share one port. */
export function socketUrl(page: Pick<Location, 'protocol' | 'host'>): string {
  return `${page.protocol === 'https:' ? 'wss' : 'ws'}://${page.host}/ws`;
}
