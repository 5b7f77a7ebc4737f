// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { PartsClient, PlaybackProblem } from './parts_client';

function client(answer: Response | Error, token = 'secret') {
  const asked: { address: string; init: RequestInit }[] = [];
  const fetching = (address: string, init: RequestInit) => {
    asked.push({ address, init });
    return answer instanceof Error ? Promise.reject(answer) : Promise.resolve(answer);
  };
  return { parts: new PartsClient('https://hub/', 'my lab', 'a/b?', token, fetching), asked };
}

const problem = async (answer: Response | Error) => {
  const error = await client(answer).parts.moment(1).catch((reason: unknown) => reason);
  expect(error).toBeInstanceOf(PlaybackProblem);
  return error as PlaybackProblem;
};

describe('a recording at the hub', () => {
  test('is asked for with the token in a header and names escaped', async () => {
    const { parts, asked } = client(Response.json({ name: 'a/b?', seconds: 3 }));
    expect((await parts.about()).seconds).toBe(3);
    expect(asked[0]!.address).toBe('https://hub/api/v1/rooms/my%20lab/recordings/a%2Fb%3F');
    expect(asked[0]!.init.headers).toEqual({ Authorization: 'Bearer secret' });
    await parts.moment(1.2345).catch(() => undefined);
    expect(asked[1]!.address).toMatch(/\/moments\/1235$|\/moments\/1234$/);
    await parts.keyFrame('left/1', 2).catch(() => undefined);
    expect(asked[2]!.address).toMatch(/\/sensors\/left%2F1\/key-frames\/2000$/);
  });

  test('that is gone, or for others, is said so, and not asked for again', async () => {
    expect(await problem(new Response('', { status: 404 }))).toMatchObject({ isFinal: true, needsToken: false });
    expect(await problem(new Response('', { status: 401 }))).toMatchObject({ isFinal: true, needsToken: true });
    const busy = Response.json({ error: { code: 'conflict', sentence: 'it is being recorded' } }, { status: 409 });
    expect((await problem(busy)).message).toBe('The recording cannot be played: it is being recorded.');
  });

  test('that cannot be reached is asked for again', async () => {
    expect((await problem(new TypeError('Failed to fetch'))).isFinal).toBe(false);
    expect((await problem(new Response('', { status: 503 }))).isFinal).toBe(false);
  });
});
