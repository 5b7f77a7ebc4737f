// SPDX-License-Identifier: Apache-2.0
// Progress until the room is first visible: the connection, then a picture of every sensor. Where there is no panel,
// also what is wrong.
import type { RoomState } from '../room_state';
import { progressTexts as texts } from '../texts';
import { element, setText } from './element';

const gaveUp_ms = 15_000; // later the panel reports sensors that send nothing

export class Progress {
  private readonly words = element('p', { role: 'status' });
  private readonly bar = element('progress', { 'aria-label': texts.title, max: '1' });
  private readonly begin_ms = performance.now();

  constructor(
    private readonly root: HTMLElement,
    private readonly state: RoomState,
    private readonly saysFaults: boolean,
  ) {
    root.replaceChildren(this.words, this.bar); // instead of the words for the time before the script has come
    this.refresh();
  }

  refresh(): void {
    const { state } = this;
    const fault = this.saysFaults ? state.broken || state.connection.sentence : '';
    this.bar.hidden = fault !== '';
    if (fault) {
      this.root.hidden = false;
      return setText(this.words, fault);
    }
    if (this.root.hidden) return;
    const online = state.onlineSensors;
    const shown = online.filter(({ id }) => state.shownSeqs.has(id)).length;
    const joined = state.connection.phase === 'joined' && state.roster !== undefined;
    const nothingToWaitFor = joined && (shown === online.length || performance.now() - this.begin_ms > gaveUp_ms);
    this.root.hidden = nothingToWaitFor || state.broken !== '' || state.connection.phase === 'waiting';
    setText(this.words, joined ? texts.waiting(shown, online.length) : texts.connecting);
    if (joined) this.bar.value = (shown + 0.5) / (online.length + 0.5);
  }
}
