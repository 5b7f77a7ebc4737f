// SPDX-License-Identifier: Apache-2.0
// The console's recordings tab: the recordings of the room that the hub keeps.
import { element, setText } from '../panel/element';
import { KeyedList } from '../panel/keyed_list';
import { recordingTexts as texts } from '../recording_texts';
import { consoleTexts } from '../console_texts';
import { RecordingRow } from './recording_row';
import type { KeptRecording, RecordingList, RecordingsApi } from './recordings_api';

const shownAtFirst = 50;
const askAgain_ms = 500; // while the hub is reading files

export class RecordingsView {
  readonly root = element('div', { class: 'recordings' });
  private readonly said = element('p', { class: 'note', role: 'status' });
  private readonly trouble = element('p', { class: 'trouble', role: 'alert' });
  private readonly more = element('button', { type: 'button', class: 'plain', hidden: '' });
  private readonly left = element('p', { class: 'note' });
  private readonly list = element('ul', { class: 'kept-list' });
  private readonly rows: KeyedList<KeptRecording>;
  private listed: KeptRecording[] = [];
  private showsAll = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly api: RecordingsApi) {
    const empty = element('li', { class: 'empty' }, texts.none);
    const events = {
      download: (name: string) => void this.trying(() => this.download(name)),
      remove: (name: string) => void this.trying(() => this.remove(name)),
      rename: (name: string, to: string) => this.trying(() => this.rename(name, to)),
    };
    this.rows = new KeyedList(this.list, ({ name }) => name, ({ name }) => new RecordingRow(name, api.room(), events), empty);
    this.more.addEventListener('click', () => {
      this.showsAll = true;
      this.list.tabIndex = -1; // the button goes away
      this.list.focus();
      this.show();
    });
    this.root.append(this.said, this.trouble, this.list, this.more, this.left);
  }

  async refresh(): Promise<void> {
    clearTimeout(this.timer);
    try {
      this.take(await this.api.list());
    } catch (error) {
      this.complain(error);
    }
  }

  private take({ recordings, left_out, unread }: RecordingList): void {
    this.listed = recordings;
    const notes = [...(unread > 0 ? [texts.unread(unread)] : []), ...(left_out > 0 ? [texts.leftOut(left_out)] : [])];
    setText(this.left, notes.join(' '));
    if (unread > 0 && !this.root.hidden) this.timer = setTimeout(() => void this.refresh(), askAgain_ms);
    this.show();
  }

  private show(): void {
    const { length } = this.listed;
    this.more.hidden = this.showsAll || length <= shownAtFirst;
    setText(this.more, texts.showAll(length));
    this.rows.show(this.more.hidden ? this.listed : this.listed.slice(0, shownAtFirst));
  }

  private async download(name: string): Promise<void> {
    const link = element('a', { href: await this.api.downloadAddress(name), download: '' });
    link.click();
  }

  private async remove(name: string): Promise<void> {
    await this.api.remove(name);
    setText(this.said, texts.removed(name));
    this.root.focus(); // the button goes away
  }

  private async rename(name: string, to: string): Promise<void> {
    const renamed = await this.api.rename(name, to);
    setText(this.said, texts.renamed(renamed.name));
    this.root.focus();
  }

  /** The hub's sentence is shown for what it refuses. The list is asked for anew in either case. */
  private async trying(what: () => Promise<void>): Promise<boolean> {
    setText(this.said, '');
    setText(this.trouble, '');
    const problem = await what().then(() => undefined, (error: unknown) => error);
    if (problem !== undefined) this.complain(problem);
    await this.refresh();
    return problem === undefined;
  }

  private complain(error: unknown): void {
    setText(this.trouble, consoleTexts.failed((error as Error).message));
  }
}
