// SPDX-License-Identifier: Apache-2.0
// What people show each other in the room: the tools, and the marks that they leave. Most of it is loaded when it is
// first needed (marks/marker.ts).
import { MarkKind, type Mark, type Marks, type Welcome } from './gen/control_pb';
import { MarkCollection } from './marks/mark_collection';
import type { Marker } from './marks/marker';
import type { Tool } from './marks/tool';
import { ToolBar } from './panel/tool_bar';
import type { RoomState } from './room_state';
import type { Standpoint } from './standpoint';
import type { NewMark } from './stream/protocol';
import { markTexts as texts } from './mark_texts';
import type { Stage } from './view/stage';
import { pivot, type ViewState } from './view/view_state';
import { asName } from './wire/name_check';

export interface MarkingParts {
  stage: Stage;
  state: RoomState;
  standpoint: Standpoint;
}

export interface MarkingEvents {
  leave(mark: NewMark): void;
  remove(ids: number[]): void;
  /** The room's marks, or this viewer's rights, have changed. */
  changed(): void;
}

export class Marking {
  private readonly marks = new MarkCollection();
  private readonly bar: ToolBar;
  private marker: Marker | undefined;
  private loading: Promise<Marker | undefined> | undefined;
  private rights = { mark: false, removeAll: false, tag: 0n };
  private newest = 0; // of this viewer's marks that undo removes
  private undo: 'none' | 'due' | 'offered' = 'none'; // not after a tool has said something newer
  private keyIsDown = false;

  constructor(
    root: HTMLElement,
    private readonly parts: MarkingParts,
    private readonly events: MarkingEvents,
  ) {
    this.bar = new ToolBar(root, { chosen: (tool) => void this.choose(tool), list: () => this.toggleList() });
    window.addEventListener('keydown', (event) => this.keyDown(event));
    window.addEventListener('keyup', (event) => event.code === 'Enter' && this.keyUp());
    window.addEventListener('blur', () => this.keyUp());
    this.bar.setMarks(false, 0);
  }

  /** Places that people have named for everybody, in the order of their names. */
  get places(): Mark[] {
    const places = this.marks.list.filter(({ kind }) => kind === MarkKind.PLACE);
    return places.sort((a, b) => a.text.localeCompare(b.text, 'en', { numeric: true }));
  }

  /** Oldest first. */
  get list(): readonly Mark[] {
    return this.marks.list;
  }

  get mayMark(): boolean {
    return this.rights.mark;
  }

  mayRemove(mark: Mark): boolean {
    const { mark: may, removeAll, tag } = this.rights;
    return may && (removeAll || (tag !== 0n && mark.authorTag === tag));
  }

  /** The hub sends all marks after this, if there are any. */
  welcomed({ mayMark, mayPlace, authorTag }: Welcome): void {
    this.rights = { mark: mayMark, removeAll: mayPlace, tag: authorTag };
    this.marks.clear();
    this.changed();
  }

  take(message: Marks): void {
    this.marks.take(message);
    if (message.refusal) this.say(texts.refused(message.refusal));
    const own = message.all ? undefined : message.marks.findLast((mark) => mark.authorTag === this.rights.tag);
    if (own && own.kind !== MarkKind.PLACE && own.authorTag !== 0n) this.offerUndo(own);
    if (message.removed.includes(this.newest) && this.undo === 'offered') this.say('');
    this.changed();
  }

  /** For everybody; false where that is not possible. */
  leavePlace(typed: string, view: ViewState): boolean {
    const text = asName(typed.trim()).trim();
    const points = [...view.position.toArray(), ...pivot(view).toArray()];
    return text !== '' && this.leave({ kind: MarkKind.PLACE, points, text });
  }

  remove(ids: number[]): void {
    this.events.remove(ids);
  }

  /** Call once per screen refresh. */
  update(): void {
    if (this.keyIsDown) this.hand?.drag(...this.middle);
    this.marker?.update();
  }

  private get hand() {
    return this.parts.standpoint.navigation.hands.tool;
  }

  private get middle(): [number, number] {
    const { clientWidth, clientHeight } = this.parts.stage.canvas;
    return [clientWidth >> 1, clientHeight >> 1];
  }

  /** For everybody; false where there is no connection. */
  leave(mark: NewMark): boolean {
    const isJoined = this.parts.state.connection.phase === 'joined';
    if (isJoined) this.events.leave(mark);
    if (isJoined && mark.kind !== MarkKind.PLACE) this.undo = 'due';
    return isJoined;
  }

  /** The hub has the mark. On a slow line one may be measuring by now: what the tool says of that stays. */
  private offerUndo({ id }: Mark): void {
    if (this.undo === 'none') return;
    this.newest = id;
    this.undo = 'offered';
    this.bar.say(texts.left, { label: texts.undo, run: () => this.remove([this.newest]) });
  }

  private say(sentence: string, action?: { label: string; run(): void }): void {
    this.undo = 'none';
    this.bar.say(sentence, action);
  }

  private changed(): void {
    const { list } = this.marks;
    const inRoom = list.filter(({ kind }) => kind !== MarkKind.PLACE).length;
    this.bar.setMarks(this.rights.mark, inRoom);
    if (this.marker) this.marker.show(list);
    else if (inRoom > 0) void this.load();
    this.events.changed();
  }

  private async choose(tool: Tool | undefined): Promise<void> {
    const { standpoint, stage } = this.parts;
    const { navigation } = standpoint;
    this.keyUp();
    this.undo = 'none';
    this.bar.setTool(tool);
    const isPointing = tool === 'point';
    const marker = tool && !isPointing ? await this.load() : this.marker;
    if (tool !== this.bar.tool) return; // another one was chosen meanwhile
    const hand = marker?.choose(isPointing ? undefined : tool);
    navigation.setTool(isPointing ? standpoint.pointing : hand);
    stage.canvas.classList.toggle('aiming', navigation.hands.tool !== undefined);
    if (tool) stage.canvas.focus({ preventScroll: true });
  }

  private async toggleList(): Promise<boolean> {
    return (await this.load())?.toggleList() ?? false;
  }

  /** Undefined where it cannot be loaded, which the page says; it is tried again later. */
  private load(): Promise<Marker | undefined> {
    this.loading ??= this.makeMarker().catch(() => {
      this.loading = undefined;
      this.say(texts.notLoaded);
      return undefined;
    });
    return this.loading;
  }

  private async makeMarker(): Promise<Marker> {
    const { Marker } = await import('./marks/marker');
    const { stage, state, standpoint } = this.parts;
    const parts = { stage, pick: standpoint.pick, root: this.bar.more };
    this.marker = new Marker(parts, {
      leave: (mark) => this.leave(mark),
      remove: (ids) => this.remove(ids),
      say: ({ sentence, action }) => this.say(sentence, action),
      goTo: (point) => standpoint.goToPoint(point),
      color: () => state.ownColor,
      mayLeave: () => this.rights.mark,
      mayRemove: (mark) => this.mayRemove(mark),
    });
    this.marker.show(this.marks.list);
    return this.marker;
  }

  /** Enter is a press in the middle of the view, Escape puts the tool away. */
  private keyDown(event: KeyboardEvent): void {
    const isForRoom = event.target instanceof Element && event.target.matches('body, canvas');
    if (!isForRoom || !this.bar.tool || event.defaultPrevented || event.repeat) return;
    if (document.body.classList.contains('console-open')) return;
    if (event.code === 'Escape') void this.choose(undefined);
    else if (event.code === 'Enter') this.keyIsDown = true;
    else return;
    event.preventDefault();
    if (this.keyIsDown) this.hand?.press(...this.middle);
  }

  private keyUp(): void {
    if (!this.keyIsDown) return;
    this.keyIsDown = false;
    this.hand?.release();
  }
}
