// SPDX-License-Identifier: Apache-2.0
// Explains the end of a connection to the user, and computes the delay before the next attempt. Close codes:
// docs/spec/wire.md §5.
import { ErrorCode } from '../gen/control_pb';
import { connectionTexts as texts } from '../texts';

export interface Ending {
  opened: boolean; // the socket had been open
  closeCode: number;
  closeReason: string;
  error: { code: ErrorCode; sentence: string } | undefined; // the hub's last error message
  ownFault: { sentence: string; unsupported: boolean } | undefined; // reason why this side closed
}

export interface Explanation {
  sentence: string;
  reload: boolean; // another attempt will not help, reloading the page may
  needsToken: boolean; // a token, or another one, will help
}

/** A token, or another one, is needed. */
const tokenErrors: readonly ErrorCode[] = [
  ErrorCode.ERROR_UNAUTHENTICATED,
  ErrorCode.ERROR_TOKEN_EXPIRED,
  ErrorCode.ERROR_TOKEN_INVALID,
  ErrorCode.ERROR_TOKEN_REVOKED,
  ErrorCode.ERROR_CODE_USED,
  ErrorCode.ERROR_WRONG_ROOM,
  ErrorCode.ERROR_WRONG_ROLE,
];

/** True if another attempt cannot succeed. A hub bans addresses that present bad tokens repeatedly. */
export function isHopeless({ error }: Ending): boolean {
  return error?.code === ErrorCode.ERROR_NO_SUCH_ROOM || needsToken(error);
}

function needsToken(error: Ending['error']): boolean {
  return error !== undefined && tokenErrors.includes(error.code);
}

/** `room` is the requested room, or empty. */
export function explain(ending: Ending, host: string, room: string): Explanation {
  const unsupported = ending.ownFault?.unsupported || ending.error?.code === ErrorCode.ERROR_UNSUPPORTED;
  return {
    sentence: unsupported ? texts.differentVersion : sentenceFor(ending, host, room),
    reload: unsupported,
    needsToken: needsToken(ending.error),
  };
}

function sentenceFor({ error, ownFault, opened, closeCode, closeReason }: Ending, host: string, room: string): string {
  if (ownFault) return ownFault.sentence;
  if (error) return explainError(error, room);
  if (!opened) return texts.noAnswer(host);
  return closeCode === 1001 ? texts.stopped : texts.gone(host, closeReason);
}

function explainError({ code, sentence }: NonNullable<Ending['error']>, room: string): string {
  switch (code) {
    case ErrorCode.ERROR_SHUTTING_DOWN:
      return texts.stopped;
    case ErrorCode.ERROR_TOO_SLOW:
      return texts.tooSlow;
    case ErrorCode.ERROR_BUSY:
      return texts.busy;
    case ErrorCode.ERROR_ROOM_FULL:
      return texts.roomFull;
    case ErrorCode.ERROR_NO_SUCH_ROOM:
      return room ? texts.noSuchRoom : texts.severalRooms;
    case ErrorCode.ERROR_UNAUTHENTICATED:
      return texts.needsToken;
    case ErrorCode.ERROR_TOKEN_EXPIRED:
      return texts.tokenExpired;
    case ErrorCode.ERROR_WRONG_ROOM:
      return texts.wrongRoom;
    case ErrorCode.ERROR_CODE_USED:
      return texts.codeUsed;
    case ErrorCode.ERROR_TOKEN_INVALID:
    case ErrorCode.ERROR_WRONG_ROLE:
      return texts.tokenInvalid;
    case ErrorCode.ERROR_TOKEN_REVOKED:
      return texts.tokenRevoked;
    default:
      return texts.hungUp(sentence);
  }
}

const firstDelay_ms = 250;
const longestDelay_ms = 5000;

const hopelessDelay_ms = 60_000;

/**
 * Doubles with every consecutive failure (`failures` counts from 1); `random` in [0, 1) spreads the attempts of many
 * pages.
 */
export function reconnectDelay_ms(failures: number, random: number, hopeless = false): number {
  const delay = hopeless ? hopelessDelay_ms : Math.min(longestDelay_ms, firstDelay_ms * 2 ** (failures - 1));
  return delay * (0.75 + 0.25 * random);
}
