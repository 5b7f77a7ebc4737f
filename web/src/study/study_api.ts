// SPDX-License-Identifier: Apache-2.0
// The hub's HTTP interface for participants of a study (docs/spec/study.md).
import type { StudyPlan } from './study_plan';
import { studyTexts as texts } from './study_texts';

export interface Session {
  participant: string;
  order: string[];
  steps: number; // that have ended
  batch: number; // the last one that the hub has
  t: number; // seconds; of its last record
}

export class StudyProblem extends Error {
  constructor(
    sentence: string,
    readonly isFinal: boolean, // asking again cannot help
  ) {
    super(sentence);
    this.name = 'StudyProblem';
  }
}

type Fetch = (address: string, init: RequestInit) => Promise<Pick<Response, 'ok' | 'status' | 'json'>>;

export class StudyApi {
  constructor(
    private readonly token: () => string,
    private readonly fetching: Fetch = (address, init) => fetch(address, init),
  ) {}

  plan(): Promise<StudyPlan> {
    return this.ask('GET', '');
  }

  enroll(plan: string): Promise<Session & { key: string }> {
    return this.ask('POST', '/participants', { agrees_to: plan });
  }

  resume(participant: string, key: string): Promise<Session> {
    return this.ask('POST', `/participants/${encodeURIComponent(participant)}/resume`, { key });
  }

  /** `isLast`: the page goes away, and nobody waits for the answer. */
  async log(participant: string, key: string, batch: number, records: readonly object[], isLast: boolean): Promise<void> {
    const path = `/participants/${encodeURIComponent(participant)}/log`;
    await this.ask('POST', path, { key, batch, records }, isLast);
  }

  private async ask<Answer>(method: 'GET' | 'POST', path: string, body?: object, keepalive = false): Promise<Answer> {
    const token = this.token();
    const headers: Record<string, string> = body ? { 'Content-Type': 'application/json' } : {};
    if (token) headers['Authorization'] = `Bearer ${token}`;
    const init: RequestInit = { method, headers, keepalive, ...(body && { body: JSON.stringify(body) }) };
    const response = await this.fetching(`api/v1/study${path}`, init).catch(() => undefined);
    if (!response) throw new StudyProblem(texts.noHub, false);
    const said = (await response.json().catch(() => undefined)) as (Answer & { error?: { sentence?: string } }) | undefined;
    if (response.ok && said) return said;
    const mayHelp = response.status === 429 || response.status >= 500;
    throw new StudyProblem(said?.error?.sentence ?? texts.answered(response.status), !mayHelp);
  }
}
