// SPDX-License-Identifier: Apache-2.0
// Finds the sensors whose newest picture is old beside those of the others, because their line or machine is slow.
// Somebody who walks would be seen where they were, beside where they are. The same rule as
// roomcast/viewer/view/late_sensors.h.
import type { PlacedSensor } from './placed_sensor';

const lateAfter_ms = 300;
const lateAfterFrames = 2.5; // a sensor of few frames a second is not late between two

type Captured = Pick<PlacedSensor, 'capture_ms'> & { entry: { online: boolean; fps: number } };

export function lateSensors<Sensor extends Captured>(sensors: readonly Sensor[]): Set<Sensor> {
  const times = sensors.map(({ entry, capture_ms }) => (entry.online ? capture_ms : undefined) ?? -Infinity);
  const newest = Math.max(...times);
  return new Set(
    sensors.filter(({ entry }, i) => {
      const allowed_ms = entry.fps > 0 ? Math.max(lateAfter_ms, (1000 * lateAfterFrames) / entry.fps) : lateAfter_ms;
      return times[i]! > -Infinity && newest - times[i]! > allowed_ms;
    }),
  );
}
