// SPDX-License-Identifier: Apache-2.0
// What the console says about a sensor that the infrared light of other cameras disturbs: figures where something is
// disturbed, and the hub's advice. Pure.
import { consoleTexts } from '../console_texts';
import type { HubInterference } from './hub_api';

const texts = consoleTexts.interference;
const leastFlickering = 0.005;
const leastNoiseRatio = 1.4;

export function interferenceText({ flickering, noise_ratio, advice }: HubInterference): string {
  const figures = [
    flickering >= leastFlickering ? texts.flickering(flickering) : '',
    noise_ratio >= leastNoiseRatio ? texts.noise(noise_ratio) : '',
  ].filter(Boolean);
  if (figures.length === 0) return texts.none;
  return [`${texts.title}: ${figures.join(', ')}.`, advice].filter(Boolean).join(' ');
}
