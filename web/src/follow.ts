// SPDX-License-Identifier: Apache-2.0
// Following a person: from their button in the list of people, or because they show everybody around, until one moves,
// presses Escape or stops it, or until the person leaves. Also says that this viewer shows everybody around.
import { FollowNote } from './panel/follow_note';
import { nameOf } from './panel/people_list';
import type { RoomState } from './room_state';
import { guideTexts } from './mark_texts';
import { followTexts as texts } from './texts';
import { followed } from './view/following';
import type { ViewState } from './view/view_state';

const longestFrame_s = 0.1;

export interface FollowEvents {
  /** Another person is followed, or nobody. */
  changed(): void;
  /** This viewer shows everybody around no more. */
  guideEnded(): void;
}

export class Follow {
  private readonly note: FollowNote;
  private person: { id: number; name: string } | undefined;
  private guide = 0; // who shows everybody around; 0: nobody
  private awaitsGuide = false; // the roster does not have the guide yet
  private lastUpdate_ms = 0;

  constructor(
    root: HTMLElement,
    private readonly state: RoomState,
    private readonly events: FollowEvents,
  ) {
    this.note = new FollowNote(root, () => this.stop());
    window.addEventListener('keydown', (event) => {
      // Others come first: a sensor to put back, the console to close.
      if (event.key !== 'Escape' || event.defaultPrevented || (!this.person && !this.isGuide)) return;
      event.preventDefault();
      this.stop();
    });
  }

  get whom(): number | undefined {
    return this.person?.id;
  }

  /** This viewer shows everybody around. */
  get isGuide(): boolean {
    return this.guide !== 0 && this.guide === this.state.welcome?.viewerId;
  }

  /** Whoever shows everybody around from now on; 0: nobody. */
  guided(viewer: number): void {
    const before = this.guide;
    const wasGuide = this.isGuide;
    this.guide = viewer;
    if (this.person && this.person.id === before && viewer !== before) this.end(guideTexts.ended(this.person.name));
    else if (wasGuide && !this.isGuide) this.note.ended('');
    if (this.isGuide) {
      this.end();
      this.note.guiding();
    } else if (viewer !== 0) this.followGuide();
  }

  private followGuide(): void {
    const viewer = this.state.roster?.viewers.find(({ id }) => id === this.guide);
    this.awaitsGuide = !viewer;
    if (!viewer) return;
    this.person = { id: viewer.id, name: nameOf(viewer) };
    this.note.guided(this.person.name);
    this.events.changed();
  }

  private stop(): void {
    if (this.isGuide) this.events.guideEnded();
    else this.end();
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
    if (this.awaitsGuide) this.followGuide();
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
