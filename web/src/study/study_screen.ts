// SPDX-License-Identifier: Apache-2.0
// What a participant sees besides the room: one sheet at a time in front of it, and a bar above it while a condition runs.
import './study.css';
import { element, setText } from '../panel/element';
import type { BoardSheet } from '../xr/board_sheet';
import { duration } from '../panel/format';
import type { Comparing, Verdict } from './comparing';
import { Questions, type Answer } from './questions';
import type { Questionnaire } from './study_plan';
import type { StudySeat } from './study_seat';
import { studyTexts as texts } from './study_texts';

export class StudyScreen {
  private readonly sheet = element('dialog', { id: 'study-sheet' });
  private readonly bar = element('section', { id: 'study-bar', 'aria-label': texts.loading, hidden: '' });
  private readonly instruction = element('p', { class: 'words' });
  private readonly left = element('span', { class: 'left', role: 'timer' });
  private readonly microphone = element('button', { type: 'button', class: 'plain' }, texts.microphone);
  private readonly stop = element('button', { type: 'button', class: 'plain' }, texts.stop);
  private readonly headset = element('button', { type: 'button', class: 'plain headset' }, texts.headset);
  private readonly barHeadset = element('button', { type: 'button', class: 'plain' }, texts.headset);
  private stopped = () => {};
  private asksToStop = false;

  /** The seat's `sheets` show the same in a headset. */
  constructor(
    private readonly toggleMicrophone: () => void,
    private readonly seat: Pick<StudySeat, 'sheets' | 'headset'>,
  ) {
    document.body.classList.add('in-study');
    this.headset.addEventListener('click', () => seat.headset.enterVr());
    this.barHeadset.addEventListener('click', () => seat.headset.enterVr());
    this.sheet.addEventListener('cancel', (event) => event.preventDefault()); // Escape leaves no step out
    this.microphone.addEventListener('click', () => this.toggleMicrophone());
    this.stop.addEventListener('click', () => this.stopOrAsk());
    this.stop.addEventListener('blur', () => this.askToStop(false));
    this.bar.append(this.instruction, element('div', { class: 'row' }, this.left, this.microphone, this.barHeadset, this.stop));
    document.querySelector('main')!.append(this.bar);
    document.body.append(this.sheet);
  }

  /** Words and buttons; resolves to the number of the one that is pressed. Without buttons it stays. */
  say(title: string, words: readonly string[], buttons: readonly string[] = []): Promise<number> {
    return new Promise((resolve) => {
      const pressed = (index: number) => {
        this.close();
        resolve(index);
      };
      const made = buttons.map((text, i) => {
        const button = element('button', { type: 'button', class: i === 0 ? 'main' : 'plain' }, text);
        button.addEventListener('click', () => pressed(i));
        return button;
      });
      const said = words.flatMap((text) => text.split(/\n{2,}/)).map((text) => text.trim());
      const paragraphs = said.map((text) => element('p', { class: 'words' }, text));
      const rows = [{ buttons: buttons.map((text, i) => ({ id: String(i), text })) }];
      const sheet: BoardSheet = { title, words: said, rows, press: (id) => pressed(Number(id)) };
      this.open(element('h2', {}, title), ...paragraphs, element('div', { class: 'row' }, ...made));
      this.seat.sheets.show(() => sheet);
      made[0]?.focus();
    });
  }

  ask(questionnaire: Questionnaire): Promise<Answer[]> {
    return new Promise((resolve) => {
      const questions = new Questions(questionnaire, (answers) => {
        this.close();
        resolve(answers);
      });
      this.open(questions.root);
      this.seat.sheets.show(() => questions.board.sheet);
    });
  }

  async compare(comparing: Comparing, decided: (verdict: Verdict) => void): Promise<void> {
    this.show(comparing);
    await comparing.run(decided);
    this.close();
  }

  /** Again, where something had to be said in between. */
  show({ root }: Comparing): void {
    if (!this.sheet.open || !this.sheet.contains(root)) this.open(root);
    this.seat.sheets.show(() => ({ title: texts.comparing, words: [texts.comparedOnScreen], rows: [], press: () => {} }));
  }

  /** While a condition runs. `stopped` is called when the participant has had enough. */
  showBar(name: string, instruction: string, hasVoice: boolean, stopped: () => void): void {
    this.bar.setAttribute('aria-label', name);
    setText(this.instruction, instruction);
    this.microphone.hidden = !hasVoice;
    this.barHeadset.hidden = !this.seat.headset.offersVr;
    this.stopped = stopped;
    this.bar.hidden = false;
    this.seat.sheets.showBar(() => this.barSheet);
    document.getElementById('room')?.focus();
  }

  showLeft(seconds: number): void {
    setText(this.left, texts.left(duration(Math.ceil(seconds))));
  }

  setMicrophone(isOn: boolean): void {
    this.microphone.setAttribute('aria-pressed', String(isOn));
  }

  hideBar(): void {
    this.seat.sheets.showBar(undefined);
    this.bar.hidden = true;
  }

  private get barSheet(): BoardSheet {
    const words = [this.instruction, this.left].map(({ textContent }) => textContent ?? '').filter(Boolean);
    const buttons = [{ id: 'stop', text: this.stop.textContent ?? '' }];
    return { title: '', words, rows: [{ buttons }], press: () => this.stopOrAsk() };
  }

  private stopOrAsk(): void {
    if (!this.asksToStop) return this.askToStop(true);
    this.askToStop(false);
    this.stopped();
  }

  private askToStop(asks: boolean): void {
    this.asksToStop = asks;
    setText(this.stop, asks ? texts.reallyStop : texts.stop);
  }

  private open(...content: Node[]): void {
    this.sheet.replaceChildren(element('div', { class: 'sheet' }, ...content, this.headset));
    this.headset.hidden = !this.seat.headset.offersVr;
    if (!this.sheet.open) this.sheet.showModal();
    this.sheet.scrollTop = 0;
  }

  private close(): void {
    this.seat.sheets.show(undefined);
    this.sheet.close();
  }
}
