// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { askedWithin, stepsOf, type Condition, type Questionnaire, type StudyPlan } from './study_plan';

function condition(name: string, seconds = 60): Condition {
  return { name, seconds, instruction: '', room: '', mode: '', latency_ms: 0, fps: 0, sensors_off: [], voice: true };
}

function questionnaire(name: string, when: Partial<Questionnaire>): Questionnaire {
  return { name, title: '', intro: '', before: false, after_condition: false, after: false, at_s: [], items: [], ...when };
}

const plan: StudyPlan = {
  id: 'p',
  name: 's',
  title: 'S',
  room: '',
  consent: 'c',
  thanks: '',
  conditions: [condition('one'), condition('two', 20)],
  questionnaires: [
    questionnaire('health', { before: true, after: true }),
    questionnaire('presence', { after_condition: true }),
    questionnaire('sickness', { at_s: [30, 10] }),
  ],
  comparisons: [{ name: 'real', title: '', intro: '', question: 'Which?', seconds: 0, before: false, after: true, pairs: ['a'] }],
};

const names = (order: string[]) =>
  stepsOf(plan, order)?.map((step) => {
    if (step.what === 'condition') return step.condition.name;
    return step.what === 'comparison' ? `${step.comparison.name}|` : `${step.questionnaire.name}?`;
  });

describe('the steps of a participant', () => {
  test('follow its own order, with questionnaires at their times', () => {
    expect(names(['two', 'one'])).toEqual(['health?', 'two', 'presence?', 'one', 'presence?', 'real|', 'health?']);
  });

  test('are none where the plan has lost a condition', () => {
    expect(names(['two', 'three'])).toBeUndefined();
  });

  test('within a condition come in order of time, as far as it lasts', () => {
    expect(askedWithin(plan, plan.conditions[0]!).map(({ at_s }) => at_s)).toEqual([10, 30]);
    expect(askedWithin(plan, plan.conditions[1]!).map(({ at_s }) => at_s)).toEqual([10]);
  });
});
