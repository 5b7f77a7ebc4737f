// SPDX-License-Identifier: Apache-2.0
// A few words on how well it is known where a sensor stands.
import { Placement, type SensorEntry } from '../gen/control_pb';
import { placementTexts as texts } from '../texts';
import { element } from './element';

/** Whether it may stand elsewhere than where it is shown. */
export function isDoubtful(entry: SensorEntry): boolean {
  return entry.moved || entry.unverified || entry.placement === Placement.UNPLACED;
}

/** Nothing for poses that were given. */
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
