// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { HubApi } from './hub_api';
import { RecordingsApi } from './recordings_api';

function answering(body: unknown) {
  const asked: { address: string; init: RequestInit }[] = [];
  const api = new HubApi(
    () => 'secret',
    (address, init) => {
      asked.push({ address, init });
      return Promise.resolve({ ok: true, status: 200, json: () => Promise.resolve(body) });
    },
  );
  return { api: new RecordingsApi(api, () => 'my lab'), asked };
}

describe('the interface to recordings', () => {
  test('escapes names, and sends the new one in the body', async () => {
    const { api, asked } = answering({});
    await api.rename('a/b ?', 'c');
    expect(asked[0]!.address).toBe('api/v1/rooms/my%20lab/recordings/a%2Fb%20%3F');
    expect(asked[0]!.init).toMatchObject({ method: 'PATCH', body: '{"name":"c"}' });
  });

  test('asks for an address without a token', async () => {
    const { api, asked } = answering({ address: 'downloads/0123' });
    expect(await api.downloadAddress('one')).toBe('api/v1/downloads/0123');
    expect(asked[0]!.init.method).toBe('POST');
  });
});
