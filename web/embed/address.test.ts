// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { frameAddress, type ViewSettings } from './address';

const settings: ViewSettings = {
  src: 'https://hub.example.org/?room=lab',
  base: 'https://example.org/page',
  token: '',
  name: '',
  place: '',
  mode: '',
  controls: '',
  muted: false,
};

const urlFor = (changes: Partial<ViewSettings>) => {
  const made = frameAddress({ ...settings, ...changes });
  return 'url' in made ? made.url.href : made.fault;
};

describe('the address of the frame', () => {
  it('has what the attributes say', () => {
    expect(urlFor({})).toBe('https://hub.example.org/?room=lab');
    expect(urlFor({ name: 'Ada & co', place: 'Door', mode: 'points', controls: 'none', muted: true })).toBe(
      'https://hub.example.org/?room=lab&name=Ada+%26+co&place=Door&mode=points&controls=none&muted=1',
    );
    expect(urlFor({ src: 'https://hub.example.org/?room=lab#at=1,2,3&look=0,0,0' })).toContain('#at=1,2,3&look=0,0,0');
  });

  it('holds the token behind its #, for this room alone', () => {
    expect(urlFor({ token: 'a.b.c' })).toBe('https://hub.example.org/?room=lab#room=lab&token=a.b.c');
  });

  it('is none without the room, and with a token that everybody could read', () => {
    expect(urlFor({ src: ' ' })).toMatch(/^src is missing/);
    expect(urlFor({ src: 'https://[' })).toMatch(/no web address/);
    expect(urlFor({ src: 'javascript:alert(1)' })).toMatch(/no web address/);
    expect(urlFor({ src: 'https://hub.example.org/' })).toMatch(/names no room/);
    expect(urlFor({ src: 'https://hub.example.org/?room=lab#token=x' })).toMatch(/property `token`/);
    expect(urlFor({ src: 'https://hub.example.org/?room=lab#code=x' })).toMatch(/property `token`/);
    expect(urlFor({ src: 'https://hub.example.org/?room=lab&token=x' })).toMatch(/property `token`/);
  });
});
