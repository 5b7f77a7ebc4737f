// SPDX-License-Identifier: Apache-2.0
// Poses that the user sets while moving sensors by hand. They are shown on this page only, until the aligner answers.
import type { RoomRoster, RoomSensor } from './room_roster';
import { pushed, type Push } from './view/nudge';

export class SensorNudges {
  private readonly bySensor = new Map<number, number[]>(); // world_from_depth

  push(entry: RoomSensor, push: Push): void {
    this.bySensor.set(entry.id, pushed(this.bySensor.get(entry.id) ?? entry.pose.worldFromDepth, push));
  }

  put(sensor: number, worldFromDepth: number[]): void {
    this.bySensor.set(sensor, worldFromDepth);
  }

  of(sensor: number): number[] | undefined {
    return this.bySensor.get(sensor);
  }

  /** False if there was no pose of the user's. */
  forget(sensor: number): boolean {
    return this.bySensor.delete(sensor);
  }

  /** Drops the user's pose once the aligner has moved the sensor or rejected the pose. */
  forgetAnswered(before: RoomRoster | undefined, now: RoomRoster): void {
    for (const entry of before?.sensors ?? []) {
      const found = now.sensors.find(({ id }) => id === entry.id)?.pose;
      const same = found?.worldFromDepth.every((number, i) => number === entry.pose.worldFromDepth[i]);
      if (!same || found?.note !== entry.pose.note) this.bySensor.delete(entry.id);
    }
  }

  /** The hub's roster with the user's poses for sensors that are being moved. */
  applyTo(roster: RoomRoster): RoomRoster {
    const sensors = roster.sensors.map((entry) => {
      const nudge = this.bySensor.get(entry.id);
      return nudge ? { ...entry, pose: { ...entry.pose, worldFromDepth: nudge } } : entry;
    });
    return { ...roster, sensors };
  }
}
