// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { parseOptions, socketUrl } from './page_options';
import { parsePoint } from './point';

describe("the page's URL", () => {
  test('may be without options', () => {
    expect(parseOptions('')).toEqual({
      mode: 'blend',
      view: undefined,
      panelOpen: undefined,
      name: '',
      room: '',
      best: false,
      playback: undefined,
      study: false,
      controls: true,
      muted: false,
      place: '',
      record: false,
    });
  });
  test('has mode, place, panel, name and room', () => {
    const options = parseOptions(
      '?mode=points&at=1,1.6,-2&look=1,1.6,-5&panel=0&name=Ada&room=lab&quality=best&record=1',
    );
    expect(options).toMatchObject({ mode: 'points', panelOpen: false, name: 'Ada', room: 'lab' });
    expect(options).toMatchObject({ best: true, record: true });
    expect(options.view!.position).toEqual(new Vector3(1, 1.6, -2));
    expect(options.view!.distance).toBeCloseTo(3);
  });
  test('may name a recording, and a moment of it', () => {
    expect(parseOptions('?play=one&from=12.5').playback).toEqual({ recording: 'one', from_s: 12.5 });
    for (const from of ['', 'x', '-3', 'Infinity'])
      expect(parseOptions(`?play=a%2Fb&from=${from}`).playback).toEqual({ recording: 'a/b', from_s: 0 });
    expect(parseOptions('?from=12').playback).toBeUndefined();
  });
  test('with invalid values gives the defaults', () => {
    for (const at of ['', '1,2', '1,2,x', '1,,3', '1,2,Infinity', '1,2,3,4']) expect(parsePoint(at)).toBeUndefined();
    expect(parseOptions('?mode=hologram&name=%00a').mode).toBe('blend');
    expect(parseOptions('?name=%00a').name).toBe('a');
    expect(parseOptions('?panel=1').panelOpen).toBe(true);
  });
  test('may end in a shared viewpoint, which takes precedence', () => {
    const { view, mode, name } = parseOptions('?mode=points&at=1,1.6,-2&name=Ada', '#at=5,1,2&look=5,1,0&mode=mesh');
    expect(view!.position).toEqual(new Vector3(5, 1, 2));
    expect([mode, name]).toEqual(['mesh', 'Ada']);
    const broken = parseOptions('?mode=points&at=1,1.6,-2', '#at=5,1,NaN&look=5,1,0&mode=mesh');
    expect([broken.mode, broken.view!.position.x]).toEqual(['points', 1]);
  });
  test('gives the socket of the same host', () => {
    expect(socketUrl({ protocol: 'http:', host: '127.0.0.1:7600' })).toBe('ws://127.0.0.1:7600/ws');
    expect(socketUrl({ protocol: 'https:', host: 'room.example' })).toBe('wss://room.example/ws');
  });
});
