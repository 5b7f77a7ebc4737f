// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { HubApi, HubRefusal } from './hub_api';

function answering(status: number, body: unknown) {
  const asked: { address: string; init: RequestInit }[] = [];
  const api = new HubApi(
    () => 'secret',
    (address, init) => {
      asked.push({ address, init });
      return Promise.resolve({ ok: status < 400, status, json: () => Promise.resolve(body) });
    },
  );
  return { api, asked };
}

describe("the hub's interface", () => {
  test('gets the token in a header and never in the address', async () => {
    const { api, asked } = answering(200, { sensors: [] });
    await api.sensors('living room');
    expect(asked[0]!.address).toBe('api/v1/rooms/living%20room/sensors');
    expect(asked[0]!.init.headers).toEqual({ Authorization: 'Bearer secret' });
  });

  test('gets the new token’s settings', async () => {
    const { api, asked } = answering(201, { code: 'c', fragment: '#room=lab&code=c', expires_at: 1 });
    expect((await api.makeToken({ room: 'lab', role: 'viewer', once: true })).fragment).toBe('#room=lab&code=c');
    expect(asked[0]!.init.method).toBe('POST');
    expect(asked[0]!.init.body).toBe('{"room":"lab","role":"viewer","once":true}');
  });

  test('shows the hub’s sentence for a refusal', async () => {
    const { api } = answering(403, { error: { code: 'wrong_role', sentence: 'That takes an admin.' } });
    const refusal = await api.tokens().catch((error: unknown) => error);
    expect(refusal).toBeInstanceOf(HubRefusal);
    expect(refusal).toMatchObject({ message: 'That takes an admin.', code: 'wrong_role' });
  });

  test('with an invalid answer is reported', async () => {
    const { api } = answering(404, 'not JSON of ours');
    await expect(api.rooms()).rejects.toThrow('The hub answered 404.');
  });

  test('mutes the microphone of a sensor', async () => {
    const { api, asked } = answering(200, {});
    await api.muteSensor('lab', 'left/right', true);
    expect(asked[0]!.address).toBe('api/v1/rooms/lab/sensors/left%2Fright');
    expect(asked[0]!.init).toMatchObject({ method: 'PATCH', body: '{"muted":true}' });
  });

  test('forgets a sensor by its name', async () => {
    const { api, asked } = answering(204, undefined);
    await api.forgetSensor('lab', 'left/right');
    expect(asked[0]!.address).toBe('api/v1/rooms/lab/sensors/left%2Fright');
    expect(asked[0]!.init.method).toBe('DELETE');
  });

  test('has an empty answer after deleting', async () => {
    const { api, asked } = answering(204, undefined);
    await api.revoke('a/b');
    expect(asked[0]!.address).toBe('api/v1/tokens/a%2Fb');
  });
});
