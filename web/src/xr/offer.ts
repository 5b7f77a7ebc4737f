// SPDX-License-Identifier: Apache-2.0
// Detects this browser's headset modes, and gives advice if there are none.

export type HeadsetMode = 'immersive-vr' | 'immersive-ar';

export interface HeadsetOffer {
  modes: HeadsetMode[];
  obstacle: 'none' | 'insecure' | 'no-webxr' | 'no-headset';
}

type Asked = Pick<XRSystem, 'isSessionSupported'>;

/** `secure`: the page came over HTTPS or from this machine; otherwise browsers do not offer headsets to it. */
export async function headsetOffer(secure: boolean, xr: Asked | undefined): Promise<HeadsetOffer> {
  if (!secure) return { modes: [], obstacle: 'insecure' };
  if (!xr) return { modes: [], obstacle: 'no-webxr' };
  const asked: HeadsetMode[] = ['immersive-vr', 'immersive-ar'];
  const answers = await Promise.all(asked.map((mode) => xr.isSessionSupported(mode).catch(() => false)));
  const modes = asked.filter((_, i) => answers[i]);
  return { modes, obstacle: modes.length > 0 ? 'none' : 'no-headset' };
}

/** Undefined where the browser has no WebXR, although the type declarations do not say so. */
export function browsersXr(): XRSystem | undefined {
  return (navigator as { xr?: XRSystem }).xr;
}
