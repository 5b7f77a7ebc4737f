// SPDX-License-Identifier: Apache-2.0
// What a participant sees besides the room: one sheet at a time in front of it, and a bar above it while a condition runs.
import './study.css';
import { element, setText } from '../panel/element';
import { duration } from '../panel/format';
import type { Comparing, Verdict } from './comparing';
import { Questions, type Answer } from './questions';
import type { Questionnaire } from './study_plan';
import { studyTexts as texts } from './study_texts';

export class StudyScreen {
  private readonly sheet = element('dialog', { id: 'study-sheet' });
  private readonly bar = element('section', { id: 'study-bar', 'aria-label': texts.loading, hidden: '' });
  private readonly instruction = element('p', { class: 'words' });
  private readonly left = element('span', { class: 'left', role: 'timer' });
  private readonly microphone = element('button', { type: 'button', class: 'plain' }, texts.microphone);
  private readonly stop = element('button', { type: 'button', class: 'plain' }, texts.stop);
  private stopped = () => {};
  private asksToStop = false;

  constructor(private readonly toggleMicrophone: () => void) {
    document.body.classList.add('in-study');
    this.sheet.addEventListener('cancel', (event) => event.preventDefault()); // Escape leaves no step out
    this.microphone.addEventListener('click', () => this.toggleMicrophone());
    this.stop.addEventListener('click', () => this.stopOrAsk());
    this.stop.addEventListener('blur', () => this.askToStop(false));
    this.bar.append(this.instruction, element('div', { class: 'row' }, this.left, this.microphone, this.stop));
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
      const paragraphs = words.flatMap((text) => text.split(/\n{2,}/)).map((text) => element('p', { class: 'words' }, text.trim()));
      this.open(element('h2', {}, title), ...paragraphs, element('div', { class: 'row' }, ...made));
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
  }

  /** While a condition runs. `stopped` is called when the participant has had enough. */
  showBar(name: string, instruction: string, hasVoice: boolean, stopped: () => void): void {
    this.bar.setAttribute('aria-label', name);
    setText(this.instruction, instruction);
    this.microphone.hidden = !hasVoice;
    this.stopped = stopped;
    this.bar.hidden = false;
    document.getElementById('room')?.focus();
  }

  showLeft(seconds: number): void {
    setText(this.left, texts.left(duration(Math.ceil(seconds))));
  }

  setMicrophone(isOn: boolean): void {
    this.microphone.setAttribute('aria-pressed', String(isOn));
  }

  hideBar(): void {
    this.bar.hidden = true;
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
    this.sheet.replaceChildren(element('div', { class: 'sheet' }, ...content));
    if (!this.sheet.open) this.sheet.showModal();
    this.sheet.scrollTop = 0;
  }

  private close(): void {
    this.sheet.close();
  }
}
