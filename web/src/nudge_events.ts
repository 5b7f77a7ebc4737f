// SPDX-License-Identifier: Apache-2.0
// Moving a sensor by hand: the console's buttons and keys -> the sensor's drawn pose, and the hub.
import type { NudgeEvents } from './panel/nudge_controls';
import type { RoomState } from './room_state';
import type { SensorNudges } from './sensor_nudges';
import type { Standpoint } from './standpoint';
import type { RoomLink } from './stream/room_link';
import { alongView, standingLike } from './view/nudge';

export interface NudgeParts {
  state: RoomState;
  nudges: SensorNudges;
  standpoint: Standpoint;
  link: RoomLink;
  /** A sensor is drawn elsewhere from now on. */
  changed(): void;
}

export function nudgeEvents({ state, nudges, standpoint, link, changed }: NudgeParts): NudgeEvents {
  return {
    push: (sensor, step) => {
      const entry = state.roster?.sensors.find(({ id }) => id === sensor);
      if (entry) nudges.push(entry, alongView(step, standpoint.current.yaw));
      changed();
    },
    putHere: (sensor) => {
      nudges.put(sensor, standingLike(standpoint.current));
      changed();
    },
    tryIt: (sensor) => {
      const nudge = nudges.of(sensor);
      if (!nudge) return 'notMoved';
      if (state.connection.phase !== 'joined') return 'notConnected';
      link.nudge(sensor, nudge);
      return 'sent';
    },
    putBack: (sensor) => {
      const wasMoved = nudges.forget(sensor);
      changed();
      return wasMoved;
    },
  };
}
