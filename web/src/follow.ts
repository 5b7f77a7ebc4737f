// SPDX-License-Identifier: Apache-2.0
// Following a person: from their button in the list of people until one moves, presses Escape or stops it, or until the
// person leaves.
import { FollowNote } from './panel/follow_note';
import { nameOf } from './panel/people_list';
import type { RoomState } from './room_state';
import { followTexts as texts } from './texts';
import { followed } from './view/following';
import type { ViewState } from './view/view_state';

const longestFrame_s = 0.1;

export interface FollowEvents {
  /** Another person is followed, or nobody. */
  changed(): void;
}

export class Follow {
  private readonly note: FollowNote;
  private person: { id: number; name: string } | undefined;
  private lastUpdate_ms = 0;

  constructor(
    root: HTMLElement,
    private readonly state: RoomState,
    private readonly events: FollowEvents,
  ) {
    this.note = new FollowNote(root, () => this.end());
    window.addEventListener('keydown', (event) => {
      // Others come first: a sensor to put back, the console to close.
      if (event.key !== 'Escape' || event.defaultPrevented || !this.person) return;
      event.preventDefault();
      this.end();
    });
  }

  get whom(): number | undefined {
    return this.person?.id;
  }

  /** Follows the person; when that is done already, stops. */
  toggle(id: number): void {
    const viewer = this.state.roster?.viewers.find((entry) => entry.id === id);
    if (!viewer || id === this.state.welcome?.viewerId) return;
    if (id === this.person?.id) return this.end();
    this.person = { id, name: nameOf(viewer) };
    this.note.following(this.person.name);
    this.events.changed();
  }

  end(sentence = ''): void {
    if (!this.person) return;
    this.person = undefined;
    this.note.ended(sentence);
    this.events.changed();
  }

  /** The people have changed. */
  rosterChanged(): void {
    const { person } = this;
    if (person && !this.state.roster?.viewers.some(({ id }) => id === person.id)) this.end(texts.left(person.name));
  }

  /** The view now; the same one while nobody is followed, or while nothing is known of where they are. */
  update(view: ViewState, now_ms: number): ViewState {
    const seconds = Math.min(longestFrame_s, (now_ms - this.lastUpdate_ms) / 1000);
    this.lastUpdate_ms = now_ms;
    const head = this.person && this.state.poses.get(this.person.id)?.head;
    if (!head) return view;
    return followed(view, head, seconds, matchMedia('(prefers-reduced-motion: reduce)').matches);
  }
}
