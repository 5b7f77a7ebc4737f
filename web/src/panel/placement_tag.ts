// SPDX-License-Identifier: Apache-2.0
// A short label for the reliability of a sensor's pose.
import { Placement, type SensorEntry } from '../gen/control_pb';
import { placementTexts as texts } from '../texts';
import { element } from './element';

/** True if the sensor's actual pose may differ from the shown one. */
export function isDoubtful(entry: SensorEntry): boolean {
  return entry.moved || entry.unverified || entry.placement === Placement.UNPLACED;
}

/** Undefined for poses that were supplied. */
export function placementTag(entry: SensorEntry): HTMLElement | undefined {
  if (entry.moved) {
    const title = entry.placementNote || texts.movedTitle;
    return element('span', { class: 'tag', title }, texts.moved);
  }
  if (entry.placement === Placement.UNPLACED) {
    return element('span', { class: 'tag', title: entry.placementNote || texts.unplacedTitle }, texts.unplaced);
  }
  if (entry.placement !== Placement.ALIGNED) return undefined;
  if (entry.unverified) {
    return element('span', { class: 'tag', title: entry.placementNote || texts.unverifiedTitle }, texts.unverified);
  }
  const error_mm = Math.max(1, Math.round(entry.expectedErrorMm));
  const title = entry.placementNote || texts.alignedTitle;
  return element(
    'span',
    { class: 'tag good', title },
    entry.expectedErrorMm > 0 ? texts.error(error_mm) : texts.aligned,
  );
}
