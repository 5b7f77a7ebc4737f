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
}

/** True if another attempt cannot succeed. A hub bans addresses that present bad tokens repeatedly. */
export function isHopeless({ error }: Ending): boolean {
  return error?.code === ErrorCode.ERROR_CODE_USED || error?.code === ErrorCode.ERROR_TOKEN_INVALID;
}

/** `room` is the requested room, or empty. */
export function explain(ending: Ending, host: string, room: string): Explanation {
  const { error, ownFault } = ending;
  if (ownFault?.unsupported || error?.code === ErrorCode.ERROR_UNSUPPORTED) {
    return { sentence: texts.differentVersion, reload: true };
  }
  if (ownFault) return { sentence: ownFault.sentence, reload: false };
  if (error) return { sentence: explainError(error, room), reload: false };
  if (!ending.opened) return { sentence: texts.noAnswer(host), reload: false };
  if (ending.closeCode === 1001) return { sentence: texts.stopped, reload: false };
  return { sentence: texts.gone(host, ending.closeReason), reload: false };
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
