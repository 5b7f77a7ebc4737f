// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { keptFragment, sharedAddress, viewFragment, viewpointOf } from './view_address';
import { lookFrom, pivot } from './view_state';

const view = lookFrom(new Vector3(0.25, 1.7, -2.6), new Vector3(0, 0.9, -5));

describe('a viewpoint in the address', () => {
  test('comes back as it was, to the millimetre', () => {
    const fragment = viewFragment(view, 'points');
    const back = viewpointOf(fragment)!;
    expect(fragment).toBe('#at=0.25,1.7,-2.6&look=0,0.9,-5&mode=points');
    expect(back.mode).toBe('points');
    expect(back.view.position.distanceTo(view.position)).toBeLessThan(1e-3);
    expect(pivot(back.view).distanceTo(pivot(view))).toBeLessThan(2e-3);
    expect(viewFragment(lookFrom(new Vector3(-1e-9, 1, 0), new Vector3(0, 1, -1)), 'mesh')).toContain('#at=0,1,0&');
  });

  test('is ignored where it is not one', () => {
    const hostile = [
      '',
      '#',
      '#at=1,2,3',
      '#look=1,2,3',
      '#at=1,2&look=0,0,0',
      '#at=1,2,3,4&look=0,0,0',
      '#at=NaN,1,1&look=0,0,0',
      '#at=1,Infinity,1&look=0,0,0',
      '#at=1,1,1&look=0,0,1e999',
      '#at=1e9,1,1&look=0,0,0',
      '#at=1,1,1&look=0,-10001,0',
      '#at=1,,1&look=0,0,0',
      `#at=${'1'.repeat(9000)},1,1&look=0,0,0`,
      '#%E0%A4%A&at=%&look=%',
    ];
    for (const hash of hostile) expect(viewpointOf(hash), hash).toBeUndefined();
    expect(viewpointOf('#at=1,1,1&look=1,1,1')!.view.distance).toBeGreaterThan(0);
    expect(viewpointOf('#at=1,1,1&look=0,0,0&mode=hologram')!.mode).toBeUndefined();
  });

  test('stays in the address; a credential, another word and a broken viewpoint do not', () => {
    expect(keptFragment('#token=secret&at=1,1,1&look=0,0,0&mode=mesh&x=y')).toBe('#at=1,1,1&look=0,0,0&mode=mesh');
    expect(keptFragment('#at=1,1,1&look=0,0,0')).toBe('#at=1,1,1&look=0,0,0');
    for (const hash of ['#token=secret', '#room=lab&code=abc', '#at=NaN,1,1&look=0,0,0', '#<script>', ''])
      expect(keptFragment(hash)).toBe('');
  });

  test('is shared with the room, and with nothing else of the own address', () => {
    const page = { origin: 'https://hub.example', pathname: '/', search: '?name=Ada', hash: '#token=secret' };
    expect(sharedAddress(page, 'lab & co', '#at=1,1,1')).toBe('https://hub.example/?room=lab%20%26%20co#at=1,1,1');
    expect(sharedAddress(page, '', '#at=1,1,1')).toBe('https://hub.example/#at=1,1,1');
  });
});
