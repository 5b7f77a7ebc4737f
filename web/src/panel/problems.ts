// SPDX-License-Identifier: Apache-2.0
// The current problems in plain words, most serious first. Pure: maps the page's state and the time to sentences.
import type { RoomRoster, RoomSensor } from '../room_roster';
import { problemTexts as texts } from '../texts';
import type { ConnectionState, SensorTraffic, Status } from '../stream/protocol';

export interface Known {
  broken: string;
  connection: ConnectionState;
  roster: RoomRoster | undefined;
  status: Status | undefined;
  hubAddress: string;
  consoleProblem?: string;
  unseen?: ReadonlySet<number>; // sensors that are silent because this viewer cannot see what they show
}

export interface Problem {
  severity: 'error' | 'notice';
  sentence: string;
  count?: string; // a sentence with a number that changes by the second: not to be announced again and again
}

const loading_ms = 10_000; // from asking for the connection; a first picture may be old when it has been decoded
const silent_ms = 3000;
const slowSilent_ms = 10_000; // on a line that takes small pictures only
const silentFrames = 3; // of a slow sensor: this many frames must be overdue

/** `room_ms` is room time, undefined before the clock is known; `date_ms` is Date.now. */
export function problems(known: Known, room_ms: number | undefined, date_ms: number): Problem[] {
  if (known.broken) return [error(known.broken)];
  const { connection } = known;
  if (connection.phase === 'waiting') return [error(connection.sentence, whatNext(connection, date_ms))];
  if (connection.phase === 'connecting' && connection.sentence) return [error(connection.sentence, texts.trying)];
  if (connection.phase === 'connecting' || !known.roster) return [notice(texts.connecting(known.hubAddress))];
  const isLoading = connection.openedAt_ms !== undefined && date_ms - connection.openedAt_ms < loading_ms;
  const now_ms = isLoading ? undefined : room_ms;
  const traffic = known.status?.sensors.filter(({ sensor }) => !known.unseen?.has(sensor)) ?? [];
  const found = sensorProblems(known.roster, traffic, now_ms, known.hubAddress);
  if (known.status?.colorProblem) found.push(notice(known.status.colorProblem));
  if (known.consoleProblem) found.push(notice(known.consoleProblem));
  return found;
}

function error(sentence: string, count = ''): Problem {
  return { severity: 'error', sentence, ...(count && { count }) };
}

function notice(sentence: string): Problem {
  return { severity: 'notice', sentence };
}

function whatNext({ retryAt_ms, reload }: ConnectionState, date_ms: number): string {
  if (reload || retryAt_ms === undefined) return '';
  const seconds = Math.ceil((retryAt_ms - date_ms) / 1000);
  return seconds > 1 ? texts.tryingIn(seconds) : texts.trying;
}

function sensorProblems(
  roster: RoomRoster,
  traffic: readonly SensorTraffic[],
  room_ms: number | undefined,
  hubAddress: string,
): Problem[] {
  if (roster.sensors.length === 0) {
    return [notice(texts.noSensors(hubAddress))];
  }
  if (!roster.sensors.some((sensor) => sensor.online)) return [error(texts.allGone)];
  const sought = roster.sensors.filter(isSought).map((sensor) => sensor.name);
  const ofEach = roster.sensors.flatMap((sensor) => {
    if (!sensor.online) return [notice(texts.gone(sensor.name))];
    const counts = traffic.find((entry) => entry.sensor === sensor.id);
    const found: Problem[] = [];
    const silence_ms = silenceOf(counts, room_ms);
    const patience_ms = counts?.isHeldBack ? Infinity : counts?.isSmall ? slowSilent_ms : silent_ms;
    if (silence_ms > Math.max(patience_ms, (1000 * silentFrames) / sensor.fps))
      found.push(error(texts.silent(sensor.name), texts.silentFor(Math.round(silence_ms / 1000))));
    if (counts?.problem) found.push(error(texts.sensor(sensor.name, counts.problem)));
    const { state, note } = sensor.pose;
    if (state === 'moved') {
      found.push(notice(texts.moved(sensor.name, inAddition(note))));
    } else if (state === 'none' && !(sought.length > 1 && isSought(sensor))) {
      const why = note ? `${note.replace(/\.$/, '')}. It` : 'it';
      found.push(notice(texts.unplaced(sensor.name, why)));
    } else if (state === 'unverified') {
      found.push(notice(texts.unverified(sensor.name, inAddition(note))));
    }
    return found;
  });
  if (sought.length > 1) ofEach.push(notice(texts.unplacedOnes(sought)));
  return [...ofEach, ...slowLine(roster, traffic)];
}

/** Of this viewer. */
function slowLine(roster: RoomRoster, traffic: readonly SensorTraffic[]): Problem[] {
  const online = new Map(roster.sensors.filter((entry) => entry.online).map(({ id, name }) => [id, name]));
  const heldBack = traffic.filter(({ isHeldBack }) => isHeldBack).flatMap(({ sensor }) => online.get(sensor) ?? []);
  if (heldBack.length > 0) return [notice(texts.heldBack(heldBack))];
  return traffic.some(({ sensor, isSmall }) => isSmall && online.has(sensor)) ? [notice(texts.coarse)] : [];
}

/** True while no reason for the missing pose is known, as for all sensors in a room's first seconds. */
function isSought({ online, pose }: RoomSensor): boolean {
  return online && pose.state === 'none' && !pose.note;
}

function inAddition(note: string): string {
  return note ? ` ${note.replace(/^./, (first) => first.toUpperCase()).replace(/\.?$/, '.')}` : '';
}

function silenceOf(counts: SensorTraffic | undefined, room_ms: number | undefined): number {
  if (room_ms === undefined || counts?.lastCapture_ms === undefined) return 0;
  return room_ms - counts.lastCapture_ms;
}
