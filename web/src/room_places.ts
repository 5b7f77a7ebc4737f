// SPDX-License-Identifier: Apache-2.0
// The places of the panel: the person's own, kept in this browser, and those that somebody has named for everybody.
import type { Marking } from './marking';
import { pointsOf } from './marks/points';
import { OwnPlaces } from './own_places';
import type { Panel } from './panel/panel';
import type { PlaceEvents } from './panel/place_list';
import type { RoomState } from './room_state';
import type { Standpoint } from './standpoint';
import type { Store } from './storage';
import { lookFrom } from './view/view_state';

export interface PlaceParts {
  state: RoomState;
  panel: Panel;
  standpoint: Standpoint;
  marking: Marking;
}

export class RoomPlaces {
  private readonly own: OwnPlaces;
  private wanted = ''; // the place to go to as soon as it is known

  /** `parts` is asked for when they are all made. */
  constructor(
    store: Store,
    private readonly parts: () => PlaceParts,
  ) {
    this.own = new OwnPlaces(store);
  }

  readonly events: PlaceEvents = {
    fromAbove: () => this.standpoint.goAbove(),
    asSensor: (sensor) => this.standpoint.goToSensor(sensor),
    goToPlace: ({ view }) => this.standpoint.goToView(view),
    keep: (name) => {
      const kept = this.own.keep(name, this.standpoint.current);
      this.show();
      return kept;
    },
    forget: ({ name }) => {
      this.own.forget(name);
      this.show();
    },
    goToMark: (place) => {
      const [eye, target] = pointsOf(place);
      this.standpoint.goToView(lookFrom(eye!, target!));
    },
    keepForAll: (name) => this.parts().marking.leavePlace(name, this.standpoint.current),
    removeForAll: ({ id }) => this.parts().marking.remove([id]),
  };

  enter(room: string): void {
    this.own.enter(room);
  }

  show(): void {
    const { panel, marking } = this.parts();
    const { places, mayMark } = marking;
    this.goToWanted();
    panel.showPlaces(this.own.list, { places, mayMark, mayRemove: (place) => marking.mayRemove(place) });
  }

  /** To a place that somebody has named for everybody; when it is known, if it is not yet. */
  goToNamed(name: string): void {
    this.wanted = name;
    this.goToWanted();
  }

  private goToWanted(): void {
    const { marking, state } = this.parts();
    const isThere = state.roster !== undefined; // else the start view would follow
    const place = isThere && this.wanted && marking.places.find(({ text }) => text === this.wanted);
    if (!place) return;
    this.wanted = '';
    this.events.goToMark(place);
  }

  private get standpoint(): Standpoint {
    return this.parts().standpoint;
  }
}
