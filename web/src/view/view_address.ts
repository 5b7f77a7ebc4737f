// SPDX-License-Identifier: Apache-2.0
// A viewpoint in the fragment of the page's address: #at=0.2,1.7,2.6&look=0,0.9,-1&mode=points, in metres of the world
// frame. The browser does not send the fragment to the hub. Also says what stays in the address after the page has
// read it: the viewpoint, and never a credential (access.ts). Pure.
import { parsePoint } from '../point';
import { maxPosition_m } from '../wire/limits';
import { drawModes, type DrawMode } from './draw_mode';
import { lookFrom, pivot, type ViewState } from './view_state';
import type { Vector3 } from 'three';

const longest = 8192; // characters of a fragment that is read: a token and a viewpoint
const decimals = 3; // millimetres

export interface Viewpoint {
  view: ViewState;
  mode: DrawMode | undefined;
}

export function isWithinLimits({ x, y, z }: Vector3): boolean {
  return [x, y, z].every((metres) => Math.abs(metres) <= maxPosition_m);
}

/** Undefined where there is none, and where numbers are missing, not finite or out of range. */
export function viewpointOf(hash: string): Viewpoint | undefined {
  if (hash.length > longest) return undefined;
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  const at = parsePoint(given.get('at'));
  const look = parsePoint(given.get('look'));
  if (!at || !look || !isWithinLimits(at) || !isWithinLimits(look)) return undefined;
  return { view: lookFrom(at, look), mode: drawModes.find((mode) => mode === given.get('mode')) };
}

function asText(point: Vector3): string {
  return point
    .toArray()
    .map((metres) => Number(metres.toFixed(decimals)) || 0) // no -0
    .join(',');
}

export function viewFragment(view: ViewState, mode?: DrawMode): string {
  return `#at=${asText(view.position)}&look=${asText(pivot(view))}${mode ? `&mode=${mode}` : ''}`;
}

/** The part of a fragment that stays in the page's address: a viewpoint, or nothing. */
export function keptFragment(hash: string): string {
  const found = viewpointOf(hash);
  return found ? viewFragment(found.view, found.mode) : '';
}

/** The address for others: the room and the viewpoint, nothing else of the own address. */
export function sharedAddress(page: Pick<Location, 'origin' | 'pathname'>, room: string, fragment: string): string {
  const search = room === '' ? '' : `?room=${encodeURIComponent(room)}`;
  return `${page.origin}${page.pathname}${search}${fragment}`;
}
