// SPDX-License-Identifier: Apache-2.0
// A short label for the reliability of a sensor's pose.
import { isPlaced, type SensorPose } from '../sensor_pose';
import { placementTexts as texts } from '../texts';
import { element } from './element';

/** True if the sensor's actual pose may differ from the shown one. */
export function isDoubtful({ state }: SensorPose): boolean {
  return state !== 'valid';
}

/** Undefined for poses that were supplied. */
export function placementTag(pose: SensorPose): HTMLElement | undefined {
  if (pose.state === 'moved') return doubtfulTag(texts.moved, pose.note || texts.movedTitle);
  if (!isPlaced(pose)) return doubtfulTag(texts.unplaced, pose.note || texts.unplacedTitle);
  if (pose.source === 'given') return undefined;
  if (pose.state === 'unverified') return doubtfulTag(texts.unverified, pose.note || texts.unverifiedTitle);
  const error_mm = Math.max(1, Math.round(pose.expectedErrorMm));
  const label = pose.expectedErrorMm > 0 ? texts.error(error_mm) : texts.aligned;
  return element('span', { class: 'tag good', title: pose.note || texts.alignedTitle }, label);
}

function doubtfulTag(label: string, title: string): HTMLElement {
  return element('span', { class: 'tag', title }, label);
}
