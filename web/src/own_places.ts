// SPDX-License-Identifier: Apache-2.0
// Places of a room that somebody has named, kept in this browser: a name and a viewpoint each.
import type { Store } from './storage';
import { viewFragment, viewpointOf } from './view/view_address';
import type { ViewState } from './view/view_state';
import { asName } from './wire/name_check';

export const mostPlaces = 50;

export interface Place {
  name: string;
  view: ViewState;
}

function placesIn(text: string | null): Place[] {
  try {
    const kept: unknown = JSON.parse(text ?? '[]');
    if (!Array.isArray(kept)) return [];
    return kept.slice(0, mostPlaces).flatMap((entry: { name?: unknown; at?: unknown } | null) => {
      if (typeof entry?.name !== 'string' || typeof entry.at !== 'string') return [];
      const found = viewpointOf(entry.at);
      const name = asName(entry.name);
      return found && name ? [{ name, view: found.view }] : [];
    });
  } catch {
    return [];
  }
}

export class OwnPlaces {
  private room = '';
  private places: Place[] = [];

  constructor(private readonly store: Store) {}

  get list(): readonly Place[] {
    return this.places;
  }

  /** Reads the room's places. */
  enter(room: string): void {
    this.room = room;
    this.places = placesIn(this.store.getItem(this.key));
  }

  /** A place of the same name is replaced. False without a name, and where there are too many. */
  keep(text: string, view: ViewState): boolean {
    const name = asName(text.trim()).trim();
    const others = this.places.filter((place) => place.name !== name);
    if (!name || others.length >= mostPlaces) return false;
    this.places = [...others, { name, view }];
    this.save();
    return true;
  }

  forget(name: string): void {
    this.places = this.places.filter((place) => place.name !== name);
    this.save();
  }

  private get key(): string {
    return `roomcast.places.${this.room}`;
  }

  private save(): void {
    const kept = this.places.map(({ name, view }) => ({ name, at: viewFragment(view) }));
    try {
      this.store.setItem(this.key, JSON.stringify(kept));
    } catch {
      // The browser's storage is full: the places last as long as the page.
    }
  }
}
