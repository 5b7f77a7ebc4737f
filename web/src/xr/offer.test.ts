// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { headsetOffer } from './offer';

const offering = (...modes: string[]) => ({
  isSessionSupported: (mode: string) => Promise.resolve(modes.includes(mode)),
});

test('a page without HTTPS gets that reason first', async () => {
  expect(await headsetOffer(false, offering('immersive-vr'))).toEqual({ modes: [], obstacle: 'insecure' });
});

test('a browser without WebXR and one without a headset get different reasons', async () => {
  expect((await headsetOffer(true, undefined)).obstacle).toBe('no-webxr');
  expect((await headsetOffer(true, offering())).obstacle).toBe('no-headset');
});

test('VR and passthrough are offered where they are supported', async () => {
  expect(await headsetOffer(true, offering('immersive-vr'))).toEqual({ modes: ['immersive-vr'], obstacle: 'none' });
  expect((await headsetOffer(true, offering('immersive-vr', 'immersive-ar'))).modes).toHaveLength(2);
});

test('a browser that fails to answer offers nothing', async () => {
  const broken = { isSessionSupported: () => Promise.reject(new Error('SecurityError')) };
  expect((await headsetOffer(true, broken)).obstacle).toBe('no-headset');
});
