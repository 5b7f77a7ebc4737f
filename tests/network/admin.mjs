// SPDX-License-Identifier: Apache-2.0
// Client of the hub's HTTP interface (docs/spec/admin.openapi.yaml), and the tokens for it.
import { setTimeout as delay } from 'node:timers/promises';

import { run } from '../cli/program.mjs';

/** The token that `roomcast token` prints. */
export async function makeToken(folder, ...options) {
  const { code, stdout, stderr } = await run('token', '--data', folder, '--json', ...options);
  if (code !== 0) throw new Error(stderr);
  return JSON.parse(stdout);
}

const answerWithin_ms = 20_000;

/**
 * Sends a request; resolves to {status, body}. Rejects without an answer: Node's fetch waits for ever when a request
 * was queued while its hub was killed (it stays in the queue of a socket that is closed).
 */
export async function ask(port, token, method, path, body) {
  const answer = await fetch(`http://127.0.0.1:${port}/api/v1${path}`, {
    method,
    headers: token ? { Authorization: `Bearer ${token}` } : {},
    body: body === undefined ? undefined : JSON.stringify(body),
    signal: AbortSignal.timeout(answerWithin_ms),
  });
  const text = await answer.text();
  return { status: answer.status, body: text === '' ? undefined : JSON.parse(text) };
}

/**
 * Waits until `isReached(state)` of a room's recording; resolves to that state. Throws if the recording failed, or after
 * `within_ms`.
 */
export async function recordingReaches(port, token, room, isReached, within_ms = 10_000) {
  const deadline = Date.now() + within_ms;
  for (;;) {
    const { body: now } = await ask(port, token, 'GET', `/rooms/${room}/recording`);
    if (isReached(now)) return now;
    if (now.state === 'failed' || Date.now() > deadline) throw new Error(`the recording: ${JSON.stringify(now)}`);
    await delay(5);
  }
}
