// SPDX-License-Identifier: Apache-2.0
// What is wrong, in plain words, worst first. Pure: what the page knows and the time go in, sentences come out.
import type { Roster } from '../gen/control_pb';
import { Placement } from '../gen/control_pb';
import type { ConnectionState, SensorTraffic, Status } from '../stream/protocol';

export interface Known {
  broken: string;
  connection: ConnectionState;
  roster: Roster | undefined;
  status: Status | undefined;
  hubAddress: string;
}

export interface Problem {
  severity: 'error' | 'notice';
  sentence: string;
}

const silent_ms = 3000;
const silentFrames = 3; // of a slow sensor: so many frames have to be overdue

/** `room_ms` is room time, undefined before the clock is known; `date_ms` is Date.now. */
export function problems(known: Known, room_ms: number | undefined, date_ms: number): Problem[] {
  if (known.broken) return [error(known.broken)];
  const { connection } = known;
  if (connection.phase === 'waiting') return [error(`${connection.sentence} ${whatNext(connection, date_ms)}`.trim())];
  if (connection.phase === 'connecting' || !known.roster) return [notice(`Connecting to ${known.hubAddress} …`)];
  const found = sensorProblems(known.roster, known.status?.sensors ?? [], room_ms, known.hubAddress);
  if (known.status?.colorProblem) found.push(notice(known.status.colorProblem));
  return found;
}

function error(sentence: string): Problem {
  return { severity: 'error', sentence };
}

function notice(sentence: string): Problem {
  return { severity: 'notice', sentence };
}

function whatNext({ retryAt_ms, reload }: ConnectionState, date_ms: number): string {
  if (reload || retryAt_ms === undefined) return '';
  const seconds = Math.ceil((retryAt_ms - date_ms) / 1000);
  return seconds > 1 ? `Trying again in ${seconds} s.` : 'Trying again.';
}

function sensorProblems(
  roster: Roster,
  traffic: readonly SensorTraffic[],
  room_ms: number | undefined,
  hubAddress: string,
): Problem[] {
  if (roster.sensors.length === 0) {
    return [notice(`No sensor is in the room yet. To add one: roomcast sensor --source sim --hub ${hubAddress}`)];
  }
  if (!roster.sensors.some((sensor) => sensor.online))
    return [error('All sensors are gone; the last pictures are shown in grey.')];
  return roster.sensors.flatMap((sensor) => {
    if (!sensor.online) return [notice(`Sensor ${sensor.name} is gone; its last picture is shown in grey.`)];
    const counts = traffic.find((entry) => entry.sensor === sensor.id);
    const found: Problem[] = [];
    const silence_ms = silenceOf(counts, room_ms);
    if (silence_ms > Math.max(silent_ms, (1000 * silentFrames) / sensor.fps))
      found.push(error(`Sensor ${sensor.name} has been silent for ${Math.round(silence_ms / 1000)} s.`));
    if (counts?.problem) found.push(error(`Sensor ${sensor.name}: ${counts.problem}`));
    if (sensor.moved) {
      const why = sensor.placementNote ? ` ${sensor.placementNote.replace(/\.?$/, '.')}` : '';
      found.push(notice(`Sensor ${sensor.name} was moved: it is shown where it was until it is aligned again.${why}`));
    } else if (sensor.placement === Placement.UNPLACED) {
      const why = sensor.placementNote ? `${sensor.placementNote.replace(/\.$/, '')}. It` : 'it';
      found.push(
        notice(`Nobody knows yet where sensor ${sensor.name} stands: ${why} is shown at a place that was made up.`),
      );
    }
    return found;
  });
}

function silenceOf(counts: SensorTraffic | undefined, room_ms: number | undefined): number {
  if (room_ms === undefined || counts?.lastCapture_ms === undefined) return 0;
  return room_ms - counts.lastCapture_ms;
}
