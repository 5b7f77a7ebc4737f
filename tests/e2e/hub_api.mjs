// SPDX-License-Identifier: Apache-2.0
// The hub's HTTP interface as docs/spec/admin.openapi.yaml describes it, played in front of a page: what it was asked
// is kept.

const now_s = () => Math.floor(Date.now() / 1000);

export class PlayedHubApi {
  constructor() {
    this.asked = [];
    this.tokens = [];
    this.room = {
      name: 'room',
      title: 'The lab',
      sensors: 1,
      viewers: 1,
      max_viewers: 32,
      max_sensors: 8,
      listed: true,
      view: 'anyone',
      send: 'token',
    };
    this.rooms = [this.room];
  }

  /** Answers for `page`; whoever has no token is refused. */
  async playFor(page) {
    await page.route('**/api/v1/**', async (route) => {
      const request = route.request();
      const path = new URL(request.url()).pathname.replace(/^.*\/api\/v1/, '');
      const authorized = (await request.headerValue('authorization')) === 'Bearer admins-token';
      const body = request.postDataJSON() ?? undefined;
      this.asked.push({ method: request.method(), path, body, url: request.url() });
      const [status, answer] = authorized
        ? this.answer(request.method(), path, body)
        : [401, refusal('unauthenticated')];
      await route.fulfill({
        status,
        contentType: 'application/json',
        body: answer === undefined ? '' : JSON.stringify(answer),
      });
    });
  }

  answer(method, path, body) {
    switch (`${method} ${path}`) {
      case 'GET /rooms':
        return [200, { rooms: this.rooms }];
      case 'POST /rooms':
        this.rooms.push({ title: body.name, sensors: 0, viewers: 0, max_viewers: 32, view: 'token', ...body });
        return [201, this.rooms.at(-1)];
      case 'GET /rooms/room':
        return [200, this.room];
      case 'PATCH /rooms/room':
        return [200, Object.assign(this.room, body)];
      case 'GET /rooms/room/sensors':
        return [200, { sensors: [] }];
      case 'GET /rooms/room/viewers':
        return [200, { viewers: [] }];
      case 'GET /tokens':
        return [200, { tokens: this.tokens }];
      case 'POST /tokens':
        return this.make(body);
    }
    const revoked = /^\/tokens\/(.*)$/.exec(path);
    if (method === 'DELETE' && revoked) {
      this.tokens.find(({ id }) => id === revoked[1]).revoked = true;
      return [204, undefined];
    }
    return [404, refusal('not_found')];
  }

  make({ room, role, name, ttl_s, once }) {
    const expires_at = now_s() + ttl_s;
    if (once) return [201, { code: 'one-time', fragment: `#room=${room}&code=one-time`, expires_at }];
    const id = `id${this.tokens.length}`;
    this.tokens.unshift({ id, room, role, name, issued_at: now_s(), expires_at, revoked: false });
    return [201, { id, token: 'signed.by.hub', expires_at }];
  }
}

function refusal(code) {
  return { error: { code, sentence: `The hub refuses: ${code}.` } };
}
