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

const patience_ms = 20_000; // for a short answer; then it counts as none

type Answered = Pick<Response, 'ok' | 'status' | 'json' | 'blob'>;
type Fetch = (address: string, init: RequestInit) => Promise<Answered>;

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

  /** Of the pair of this number in the plan. */
  async picture(participant: string, key: string, comparison: string, pair: number, kind: 'real' | 'drawn'): Promise<Blob> {
    const path = `/participants/${encodeURIComponent(participant)}/picture`;
    const response = await this.fetch('POST', path, { key, comparison, pair, kind });
    if (!response.ok) throw await problemOf(response);
    return response.blob().catch(cutOff);
  }

  private async ask<Answer>(method: 'GET' | 'POST', path: string, body?: object, keepalive = false): Promise<Answer> {
    const response = await this.fetch(method, path, body, { keepalive, signal: AbortSignal.timeout(patience_ms) });
    if (!response.ok) throw await problemOf(response);
    const said = (await response.json().catch(notJson)) as Answer | undefined;
    if (said) return said;
    throw new StudyProblem(texts.answered(response.status), true);
  }

  private async fetch(method: 'GET' | 'POST', path: string, body?: object, more: RequestInit = {}): Promise<Answered> {
    const token = this.token();
    const headers: Record<string, string> = body ? { 'Content-Type': 'application/json' } : {};
    if (token) headers['Authorization'] = `Bearer ${token}`;
    const init: RequestInit = { method, headers, ...more, ...(body && { body: JSON.stringify(body) }) };
    const response = await this.fetching(`api/v1/study${path}`, init).catch(() => undefined);
    if (!response) throw new StudyProblem(texts.noHub, false);
    return response;
  }
}

/** The head of the answer came and the rest did not: as if the hub had not answered. */
function cutOff(): never {
  throw new StudyProblem(texts.noHub, false);
}

function notJson(error: unknown): undefined {
  if (!(error instanceof SyntaxError)) cutOff();
}

async function problemOf(response: Answered): Promise<StudyProblem> {
  const said = (await response.json().catch(() => undefined)) as { error?: { sentence?: string } } | undefined;
  const mayHelp = response.status === 429 || response.status >= 500;
  return new StudyProblem(said?.error?.sentence ?? texts.answered(response.status), !mayHelp);
}
