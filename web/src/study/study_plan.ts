// SPDX-License-Identifier: Apache-2.0
// A study as the hub gives it to pages (docs/spec/study.md), and what one participant goes through, step by step.

export interface Condition {
  name: string;
  seconds: number;
  instruction: string;
  room: string; // '': the study's
  mode: '' | 'blend' | 'mesh' | 'points';
  latency_ms: number;
  fps: number; // 0: all
  sensors_off: string[];
  voice: boolean;
}

export interface Item {
  name: string;
  text: string;
  kind: 'scale' | 'choice' | 'number' | 'text';
  points: number;
  labels: string[];
  choices: string[];
  required: boolean;
}

export interface Questionnaire {
  name: string;
  title: string;
  intro: string;
  before: boolean;
  after_condition: boolean;
  after: boolean;
  at_s: number[];
  items: Item[];
}

/** Pairs of a photograph and a drawn view. */
export interface Comparison {
  name: string;
  title: string;
  intro: string;
  question: string;
  seconds: number; // for which they are shown; 0: until one is chosen
  before: boolean;
  after: boolean;
  pairs: string[];
}

export interface StudyPlan {
  id: string;
  name: string;
  title: string;
  room: string;
  consent: string;
  thanks: string;
  conditions: Condition[];
  questionnaires: Questionnaire[];
  comparisons: Comparison[];
}

export type Step =
  | { what: 'condition'; condition: Condition }
  | { what: 'questionnaire'; questionnaire: Questionnaire }
  | { what: 'comparison'; comparison: Comparison };

/** Undefined: the plan has been changed, and a condition of this order is not there any more. */
export function stepsOf(plan: StudyPlan, order: readonly string[]): Step[] | undefined {
  const asked = (at: 'before' | 'after_condition' | 'after'): Step[] =>
    plan.questionnaires.filter((questionnaire) => questionnaire[at]).map((questionnaire) => ({ what: 'questionnaire', questionnaire }));
  const compared = (at: 'before' | 'after'): Step[] =>
    plan.comparisons.filter((comparison) => comparison[at]).map((comparison) => ({ what: 'comparison', comparison }));
  const steps = [...asked('before'), ...compared('before')];
  for (const name of order) {
    const condition = plan.conditions.find((one) => one.name === name);
    if (!condition) return undefined;
    steps.push({ what: 'condition', condition }, ...asked('after_condition'));
  }
  return [...steps, ...compared('after'), ...asked('after')];
}

/** Questionnaires within a condition, in order of time. */
export function askedWithin(plan: StudyPlan, { seconds }: Condition): { at_s: number; questionnaire: Questionnaire }[] {
  return plan.questionnaires
    .flatMap((questionnaire) => questionnaire.at_s.map((at_s) => ({ at_s, questionnaire })))
    .filter(({ at_s }) => at_s < seconds)
    .sort((a, b) => a.at_s - b.at_s);
}
