// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { StudyApi, StudyProblem } from './study_api';
import { studyTexts as texts } from './study_texts';

type Body = () => Promise<unknown>;

function apiThat(status: number, json: Body, blob: Body = json) {
  const answer = { ok: status < 300, status, json: json as () => Promise<never>, blob: blob as () => Promise<Blob> };
  return new StudyApi(
    () => '',
    () => Promise.resolve(answer),
  );
}

const resume = (api: StudyApi) => api.resume('P001', 'key');
const problem = (of: Promise<unknown>) => of.then(() => undefined, (error: StudyProblem) => [error.message, error.isFinal]);

describe('what a hub does not answer in full', () => {
  test.each([new TypeError('network error'), new DOMException('too late', 'TimeoutError')])('may come when it is asked again: %s', async (error) => {
    const cut = () => Promise.reject(error);
    expect(await problem(resume(apiThat(200, cut)))).toEqual([texts.noHub, false]);
    expect(await problem(apiThat(200, cut).picture('P001', 'key', 'a', 0, 'real'))).toEqual([texts.noHub, false]);
  });

  test('is refused for good when the hub refused it and only its reason is missing', async () => {
    const cut = () => Promise.reject(new TypeError('network error'));
    expect(await problem(resume(apiThat(403, cut)))).toEqual([texts.answered(403), true]);
    expect(await problem(resume(apiThat(503, cut)))).toEqual([texts.answered(503), false]);
  });
});

describe('an answer', () => {
  test('that is no JSON comes from no hub, again and again', async () => {
    const page = () => Promise.reject(new SyntaxError('<html>'));
    expect(await problem(resume(apiThat(200, page)))).toEqual([texts.answered(200), true]);
  });

  test('that refuses has its reason', async () => {
    const refused = () => Promise.resolve({ error: { sentence: 'No such participant.' } });
    expect(await problem(resume(apiThat(404, refused)))).toEqual(['No such participant.', true]);
    expect(await problem(resume(apiThat(429, refused)))).toEqual(['No such participant.', false]);
  });
});
