// SPDX-License-Identifier: Apache-2.0
// The address of the frame of a <roomcast-view>, from its attributes. Pure.

export interface ViewSettings {
  src: string;
  base: string; // of the page around it
  token: string;
  name: string;
  place: string;
  mode: string;
  controls: string;
  muted: boolean;
}

const texts = {
  none: 'src is missing: it is the room’s address, as in https://hub.example.org/?room=lab',
  notWeb: 'src is no web address; it is written as in https://hub.example.org/?room=lab',
  noRoom: 'src names no room; it is written as in https://hub.example.org/?room=lab',
  credential: 'src holds a token or a code, which everybody could read in this page; set the property `token` instead',
};

/** The address, or a sentence that says why there is none. A token is behind its #, which browsers do not send. */
export function frameAddress(settings: ViewSettings): { url: URL } | { fault: string } {
  if (settings.src.trim() === '') return { fault: texts.none };
  const url = parsed(settings.src, settings.base);
  if (!url || !/^https?:$/.test(url.protocol)) return { fault: texts.notWeb };
  if (!url.searchParams.get('room')) return { fault: texts.noRoom };
  const fragment = new URLSearchParams(url.hash.slice(1));
  if (['token', 'code'].some((part) => fragment.has(part) || url.searchParams.has(part))) return { fault: texts.credential };
  const { name, place, mode, controls } = settings;
  for (const [part, value] of Object.entries({ name, place, mode, controls })) {
    if (value) url.searchParams.set(part, value);
  }
  if (settings.muted) url.searchParams.set('muted', '1');
  if (settings.token) {
    fragment.set('room', url.searchParams.get('room')!);
    fragment.set('token', settings.token);
    url.hash = fragment.toString();
  }
  return { url };
}

function parsed(text: string, base: string): URL | undefined {
  try {
    return new URL(text, base);
  } catch {
    return undefined;
  }
}
