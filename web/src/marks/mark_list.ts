// SPDX-License-Identifier: Apache-2.0
// The room's marks as a list: to go to one, to remove one, and to hide them all in one's own picture.
import { MarkKind, type Mark } from '../gen/control_pb';
import { element, setText } from '../panel/element';
import { checkbox, labelled } from '../panel/form';
import { KeyedList, type Row } from '../panel/keyed_list';
import { markTexts as texts } from '../mark_texts';
import { inMetres } from './mark_scene';
import { pointsOf } from './points';

export interface MarkListEvents {
  go(mark: Mark): void;
  remove(ids: number[]): void;
  shown(shown: boolean): void;
}

interface Entry {
  mark: Mark;
  mayRemove: boolean;
}

export function titleOf(mark: Mark): string {
  const [from, to] = pointsOf(mark);
  if (mark.kind === MarkKind.DISTANCE) return texts.distance(inMetres(from!.distanceTo(to!)));
  return mark.kind === MarkKind.SKETCH ? texts.sketch : mark.text;
}

export class MarkList {
  readonly root: HTMLElement;
  private readonly list = element('ul');
  private readonly rows: KeyedList<Entry>;
  private readonly own = element('button', { type: 'button', class: 'plain' });
  private removable: number[] = [];
  private wasAsked = false;

  constructor(private readonly events: MarkListEvents) {
    const empty = element('li', { class: 'none' }, texts.none);
    this.rows = new KeyedList<Entry>(this.list, ({ mark }) => String(mark.id), (entry) => this.row(entry), empty);
    const shown = checkbox(true);
    shown.addEventListener('change', () => events.shown(shown.checked));
    this.own.addEventListener('click', () => this.removeAll());
    this.own.addEventListener('blur', () => this.ask(false));
    this.root = element('section', { class: 'mark-list', 'aria-label': texts.listTitle, hidden: '' });
    this.root.append(labelled(texts.show, shown, 'field box'), this.list, this.own);
  }

  /** `mayRemove` says of which marks this viewer may dispose. */
  show(marks: readonly Mark[], mayRemove: (mark: Mark) => boolean): void {
    const entries = marks.map((mark) => ({ mark, mayRemove: mayRemove(mark) }));
    this.removable = entries.filter((entry) => entry.mayRemove).map(({ mark }) => mark.id);
    this.own.hidden = this.removable.length < 2;
    this.ask(false);
    this.rows.show(entries.reverse()); // the newest first
  }

  /** What cannot be undone takes a second press. */
  private removeAll(): void {
    if (!this.wasAsked) return this.ask(true);
    this.events.remove(this.removable);
  }

  private ask(wasAsked: boolean): void {
    this.wasAsked = wasAsked;
    const { length } = this.removable;
    setText(this.own, wasAsked ? texts.reallyRemove(length) : texts.removeAll(length));
  }

  private row({ mark }: Entry): Row<Entry> {
    const swatch = element('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = `#${mark.colorRgb.toString(16).padStart(6, '0')}`;
    const title = titleOf(mark);
    const author = mark.author || texts.somebody;
    const go = element('button', { type: 'button', class: 'go' }, title, element('small', {}, author));
    go.addEventListener('click', () => this.events.go(mark));
    const remove = element('button', { type: 'button', class: 'plain', 'aria-label': texts.remove(title) }, '×');
    remove.addEventListener('click', () => {
      this.root.querySelector('input')?.focus(); // the button goes away
      this.events.remove([mark.id]);
    });
    const update = ({ mayRemove }: Entry) => (remove.hidden = !mayRemove);
    return { root: element('li', {}, swatch, go, remove), update };
  }
}
