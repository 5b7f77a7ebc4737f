// SPDX-License-Identifier: Apache-2.0
// What a sensor's card says of how the hub has it send.
import { consoleTexts as texts } from '../console_texts';
import type { HubSensor } from './hub_api';

export function sendingText(sensor: Pick<HubSensor, 'unseen' | 'share_mbit'>): string {
  if (sensor.unseen) return texts.unseen;
  return sensor.share_mbit ? texts.share(sensor.share_mbit) : '';
}
