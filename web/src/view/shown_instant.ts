// SPDX-License-Identifier: Apache-2.0
// The instant at which the room is drawn: sensors take their pictures at different times, and what moves is drawn where it
// is at one. The same rule as RoomRenderer::shown_instant.

/** Surfaces are not moved for longer than this: nobody knows how they go on. */
export const maxAhead_ms = 70;

/** In the middle between the sensors' newest pictures, of those that can be brought to one instant. Room time. */
export function shownInstant_ms(captures_ms: readonly number[]): number | undefined {
  if (captures_ms.length === 0) return undefined;
  const newest = Math.max(...captures_ms);
  const oldest = Math.min(...captures_ms.filter((time) => newest - time <= 2 * maxAhead_ms));
  return oldest + (newest - oldest) / 2;
}

/** How far the instant is after a picture, at most `maxAhead_ms` either way; seconds. */
export function aheadOf_s(capture_ms: number | undefined, instant_ms: number | undefined): number {
  if (capture_ms === undefined || instant_ms === undefined) return 0;
  return Math.min(Math.max(instant_ms - capture_ms, -maxAhead_ms), maxAhead_ms) / 1000;
}
