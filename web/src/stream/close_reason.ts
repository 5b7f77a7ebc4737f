// SPDX-License-Identifier: Apache-2.0
// Why a connection ended, in words for the person in front of the page, and how long to wait before the next try.
// Close codes: docs/spec/wire.md §5.
import { ErrorCode } from '../gen/control_pb';

export interface Ending {
  opened: boolean; // the socket had been open
  closeCode: number;
  closeReason: string;
  error: { code: ErrorCode; sentence: string } | undefined; // the hub's last word
  ownFault: { sentence: string; unsupported: boolean } | undefined; // why this side closed
}

export interface Explanation {
  sentence: string;
  reload: boolean; // trying again will not help, loading the page again may
}

const differentVersion = 'The hub speaks another version of roomcast than this page. Load the page again.';

export function explain(ending: Ending, host: string): Explanation {
  const { error, ownFault } = ending;
  if (ownFault?.unsupported || error?.code === ErrorCode.ERROR_UNSUPPORTED) {
    return { sentence: differentVersion, reload: true };
  }
  if (ownFault) return { sentence: ownFault.sentence, reload: false };
  if (error) return { sentence: explainError(error), reload: false };
  if (!ending.opened) return { sentence: `The hub at ${host} does not answer.`, reload: false };
  if (ending.closeCode === 1001) return { sentence: 'The hub has stopped.', reload: false };
  const reason = ending.closeReason ? ` It said: ${ending.closeReason}` : '';
  return { sentence: `The connection to the hub at ${host} is gone.${reason}`, reload: false };
}

function explainError({ code, sentence }: NonNullable<Ending['error']>): string {
  switch (code) {
    case ErrorCode.ERROR_SHUTTING_DOWN:
      return 'The hub has stopped.';
    case ErrorCode.ERROR_TOO_SLOW:
      return 'This computer or its connection was too slow, and the hub hung up.';
    case ErrorCode.ERROR_ROOM_FULL:
      return 'The room is full.';
    case ErrorCode.ERROR_NO_SUCH_ROOM:
      return 'The hub has no room of that name.';
    default:
      return `The hub hung up: ${sentence || 'it gave no reason.'}`;
  }
}

const firstDelay_ms = 250;
const longestDelay_ms = 5000;

/** Doubles with every failure in a row (`failures` counts from 1); `random` in [0, 1) spreads many pages out. */
export function reconnectDelay_ms(failures: number, random: number): number {
  const delay = Math.min(longestDelay_ms, firstDelay_ms * 2 ** (failures - 1));
  return delay * (0.75 + 0.25 * random);
}
