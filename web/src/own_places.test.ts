// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { mostPlaces, OwnPlaces } from './own_places';
import { lookFrom } from './view/view_state';

const view = lookFrom(new Vector3(1, 1.5, 2), new Vector3(0, 1, 0));

function storeOf(values = new Map<string, string>()) {
  return {
    getItem: (key: string) => values.get(key) ?? null,
    setItem: (key: string, value: string) => void values.set(key, value),
    removeItem: (key: string) => void values.delete(key),
  };
}

function placesOf(store = storeOf(), room = 'lab'): OwnPlaces {
  const places = new OwnPlaces(store);
  places.enter(room);
  return places;
}

describe('named places', () => {
  test('are there again, in the same room only', () => {
    const store = storeOf();
    expect(placesOf(store).keep(' desk ', view)).toBe(true);
    const [desk] = placesOf(store).list;
    expect(desk!.name).toBe('desk');
    expect(desk!.view.position.distanceTo(view.position)).toBeLessThan(1e-3);
    expect(placesOf(store, 'hall').list).toEqual([]);
  });

  test('are replaced by name, and can be removed', () => {
    const places = placesOf();
    places.keep('desk', view);
    places.keep('door', view);
    places.keep('desk', lookFrom(new Vector3(5, 1, 5), new Vector3()));
    expect(places.list.map(({ name }) => name)).toEqual(['door', 'desk']);
    expect(places.list[1]!.view.position.x).toBe(5);
    places.forget('door');
    expect(places.list.map(({ name }) => name)).toEqual(['desk']);
  });

  test('need a name, and are not endless', () => {
    const places = placesOf();
    expect(places.keep(' \u0000', view)).toBe(false);
    for (let i = 0; i < mostPlaces; i++) expect(places.keep(`p${i}`, view)).toBe(true);
    expect(places.keep('one more', view)).toBe(false);
    expect(places.keep('p3', view)).toBe(true);
  });

  test('survive a storage with broken content, and one that is full', () => {
    for (const text of ['{', 'null', '{"a":1}', '[null,1,{"name":"a"},{"name":"b","at":"#at=NaN,1,1&look=0,0,0"}]']) {
      expect(placesOf(storeOf(new Map([['roomcast.places.lab', text]]))).list).toEqual([]);
    }
    const full = { ...storeOf(), setItem: () => { throw new DOMException('full', 'QuotaExceededError'); } };
    const places = placesOf(full);
    expect(places.keep('desk', view)).toBe(true);
    expect(places.list.length).toBe(1);
  });
});
