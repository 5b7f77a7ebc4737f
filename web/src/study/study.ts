// SPDX-License-Identifier: Apache-2.0
// A study in the page, for one participant: consent, then step by step conditions and questionnaires, with a log of what
// happens. After a reload it goes on with the step that had not ended.
import { pageTime_ms } from '../stream/protocol';
import { Comparing, type Kind } from './comparing';
import { Conditions } from './conditions';
import { Observer } from './observer';
import { SessionLog } from './session_log';
import { StudyApi, StudyProblem, type Session } from './study_api';
import { askedWithin, stepsOf, type Comparison, type Condition, type Questionnaire, type Step, type StudyPlan } from './study_plan';
import { StudyScreen } from './study_screen';
import type { StudySeat } from './study_seat';
import { studyTexts as texts } from './study_texts';

const storeKey = 'roomcast.study';
const flush_ms = 2000;
const tick_ms = 100;
const poll_ms = 100;

interface Kept {
  participant: string;
  key: string;
  startedAt_ms: number; // page time
}

const until = async (isDone: () => boolean) => {
  while (!isDone()) await new Promise((resolve) => setTimeout(resolve, poll_ms));
};

export class Study {
  private readonly screen: StudyScreen;
  private readonly api: StudyApi;
  private readonly conditions: Conditions;
  private plan!: StudyPlan;
  private kept!: Kept;
  private log!: SessionLog;
  private observer!: Observer;
  private hasStopped = false;

  constructor(private readonly seat: StudySeat) {
    this.api = new StudyApi(() => seat.token());
    this.screen = new StudyScreen(() => void seat.sound.toggle(), seat);
    this.conditions = new Conditions(seat);
  }

  async run(): Promise<void> {
    void this.screen.say(texts.loading, []);
    this.plan = await this.asking(() => this.api.plan(), texts.notHere);
    document.title = `${this.plan.title} · roomcast`;
    const session = (await this.continued()) ?? (await this.begun());
    if (!session) return void this.screen.say(texts.declinedTitle, [texts.declined]);
    const steps = stepsOf(this.plan, session.order);
    if (!steps) return void this.screen.say(texts.loading, [texts.changed]);
    this.watch(session);
    for (const [number, step] of steps.entries()) {
      if (number < session.steps) continue;
      await this.take(number, step, steps);
      if (this.hasStopped) break;
    }
    await this.finish();
  }

  /** The session of this tab, if there is one. */
  private async continued(): Promise<Session | undefined> {
    const kept = readKept(this.seat);
    if (!kept) return undefined;
    this.kept = kept;
    try {
      return await this.api.resume(kept.participant, kept.key);
    } catch (error) {
      if (!(error instanceof StudyProblem)) throw error;
      const choices = error.isFinal ? [texts.anew] : [texts.tryAgain];
      await this.screen.say(this.plan.title, [texts.lost(error.message)], choices);
      if (error.isFinal) this.seat.store.removeItem(storeKey);
      return this.continued();
    }
  }

  /** Undefined: they do not want to take part. */
  private async begun(): Promise<Session | undefined> {
    const { plan, screen } = this;
    if ((await screen.say(plan.title, [texts.consentTitle, plan.consent], [texts.agree, texts.decline])) === 1) return undefined;
    const session = await this.asking(() => this.api.enroll(plan.id), texts.notHere);
    this.kept = { participant: session.participant, key: session.key, startedAt_ms: pageTime_ms() };
    this.seat.store.setItem(storeKey, JSON.stringify(this.kept));
    await screen.say(plan.title, [texts.number(session.participant)], [texts.next]);
    return session;
  }

  /** Asks the hub until it answers; what it refuses for good stays on the screen. */
  private async asking<Answer>(ask: () => Promise<Answer>, words: (reason: string) => string): Promise<Answer> {
    for (;;) {
      try {
        return await ask();
      } catch (error) {
        if (!(error instanceof StudyProblem)) throw error;
        await this.screen.say(texts.consentTitle, [words(error.message)], error.isFinal ? [] : [texts.tryAgain]);
      }
    }
  }

  private watch({ batch, t }: Session): void {
    const { seat, kept, api } = this;
    this.log = new SessionLog(batch, (number, records, isLast) => api.log(kept.participant, kept.key, number, records, isLast));
    const least_s = t; // a clock that was set back does not turn the log back
    this.observer = new Observer(seat, this.log, () => Math.max(least_s, (pageTime_ms() - kept.startedAt_ms) / 1000));
    if (batch > 0) this.observer.add('page', { what: 'loaded', on: true, note: '' });
    this.observer.begin();
    setInterval(() => void this.keepOn(), flush_ms);
    window.addEventListener('pagehide', () => this.log.leave());
  }

  private async keepOn(): Promise<void> {
    await this.log.flush();
    this.screen.setMicrophone(this.seat.sound.isOn);
    if (this.log.isLost && !this.hasStopped) {
      this.hasStopped = true;
      this.conditions.end();
      this.screen.hideBar();
      void this.screen.say(this.plan.title, [texts.lost(this.log.problem)]);
    }
  }

  private async take(number: number, step: Step, steps: readonly Step[]): Promise<void> {
    const { name } = step.what === 'condition' ? step.condition : step.what === 'comparison' ? step.comparison : step.questionnaire;
    if (step.what === 'condition') await this.prepare(step.condition, steps);
    this.note(number, step.what, name, true);
    if (step.what === 'condition') await this.show(step.condition);
    else if (step.what === 'comparison') await this.compare(step.comparison);
    else await this.question(step.questionnaire, 0);
    if (this.log.isLost) return;
    this.note(number, step.what, name, false);
    await this.log.flush();
  }

  private note(step: number, what: Step['what'], name: string, begins: boolean): void {
    this.observer.add('steps', { step, what, name, begins });
  }

  /** Says what comes, behind which the condition is applied. */
  private async prepare(condition: Condition, steps: readonly Step[]): Promise<void> {
    const all = steps.filter(({ what }) => what === 'condition');
    const part = all.findIndex((step) => step.what === 'condition' && step.condition === condition) + 1;
    const title = texts.partTitle(part, all.length);
    void this.screen.say(title, [texts.waiting]);
    await until(() => this.seat.state.welcome !== undefined && this.seat.state.roster !== undefined);
    await this.enterRoom(condition);
    const minutes = (condition.seconds / 60).toLocaleString('en-GB', { maximumFractionDigits: 1 });
    const words = [condition.instruction, texts.about(minutes)].filter(Boolean);
    const troubles = this.conditions.apply(condition);
    for (const note of troubles) this.observer.add('page', { what: 'trouble', on: true, note });
    await this.screen.say(title, words, [texts.start]);
  }

  /** Another room takes another page, which goes on here. */
  private async enterRoom({ room }: Condition): Promise<void> {
    const wanted = room || this.plan.room;
    if (wanted === '' || wanted === this.seat.state.welcome!.room) return;
    await this.log.flush();
    location.search = new URLSearchParams({ study: '1', room: wanted }).toString();
    await new Promise(() => {});
  }

  private async show(condition: Condition): Promise<void> {
    const within = askedWithin(this.plan, condition);
    let shown_s = 0;
    this.screen.showBar(condition.instruction || this.plan.title, condition.instruction, condition.voice, () => (this.hasStopped = true));
    let before_ms = pageTime_ms();
    while (shown_s < condition.seconds && !this.hasStopped) {
      this.screen.showLeft(condition.seconds - shown_s);
      await new Promise((resolve) => setTimeout(resolve, tick_ms));
      const now_ms = pageTime_ms();
      shown_s += (now_ms - before_ms) / 1000;
      before_ms = now_ms;
      if (!within[0] || shown_s < within[0].at_s) continue;
      const { at_s, questionnaire } = within.shift()!;
      await this.question(questionnaire, at_s);
      before_ms = pageTime_ms();
    }
    this.screen.hideBar();
    this.conditions.end();
  }

  private async question(questionnaire: Questionnaire, at_s: number): Promise<void> {
    const from_ms = pageTime_ms();
    const answers = await this.screen.ask(questionnaire);
    const after_s = Number(((pageTime_ms() - from_ms) / 1000).toFixed(2));
    for (const { item, value } of answers) {
      this.observer.add('answers', { questionnaire: questionnaire.name, item, value, at_s, after_s });
    }
  }

  private async compare(comparison: Comparison): Promise<void> {
    const comparing: Comparing = new Comparing(comparison, async (index: number, kind: Kind) => {
      const { participant, key } = this.kept;
      const picture = await this.asking(() => this.api.picture(participant, key, comparison.name, index, kind), texts.noPicture);
      this.screen.show(comparing);
      return picture;
    });
    await this.screen.compare(comparing, (verdict) => {
      this.observer.add('comparisons', { comparison: comparison.name, ...verdict });
    });
  }

  private async finish(): Promise<void> {
    const { plan, log, screen } = this;
    if (log.isLost) return;
    this.seat.store.removeItem(storeKey);
    const [title, words] = this.hasStopped ? [texts.stoppedTitle, texts.stopped] : [texts.thanksTitle, plan.thanks || texts.thanks];
    const number = texts.number(this.kept.participant);
    this.observer.end();
    while (!log.isEmpty && !log.isLost) {
      void screen.say(title, [words, number, log.problem ? texts.notSent(log.problem) : texts.sending]);
      await log.flush();
      if (!log.isEmpty) await new Promise((resolve) => setTimeout(resolve, flush_ms));
    }
    void screen.say(title, [words, number, texts.sent]);
  }
}

function readKept({ store }: StudySeat): Kept | undefined {
  try {
    const kept = JSON.parse(store.getItem(storeKey) ?? '{}') as Partial<Kept>;
    const { participant, key, startedAt_ms } = kept;
    return participant && key && startedAt_ms ? { participant, key, startedAt_ms } : undefined;
  } catch {
    return undefined;
  }
}
