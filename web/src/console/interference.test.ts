// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { interferenceText } from './interference';

const quiet = { flickering: 0.001, noise_ratio: 1.1, neighbour: '', shared: 0, advice: '' };

test('an undisturbed sensor is said to be so', () => {
  expect(interferenceText(quiet)).toBe('no interference by other infrared cameras');
});

test('figures that count are named, with the advice of the hub', () => {
  const text = interferenceText({ ...quiet, flickering: 0.034, advice: '"right" lights 40 % of it. Turn one.' });
  expect(text).toBe('Infrared interference: 3.4 % of still readings come and go. "right" lights 40 % of it. Turn one.');
});

test('flicker and noise are both named', () => {
  expect(interferenceText({ ...quiet, flickering: 0.2, noise_ratio: 2.46 })).toBe(
    'Infrared interference: 20 % of still readings come and go, noise up to 2.5 times the usual.',
  );
});
