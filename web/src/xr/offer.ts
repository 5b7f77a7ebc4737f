// SPDX-License-Identifier: Apache-2.0
// What this browser can do with a headset, and what a person can do when it cannot.

export type HeadsetMode = 'immersive-vr' | 'immersive-ar';

export interface HeadsetOffer {
  modes: HeadsetMode[];
  obstacle: 'none' | 'insecure' | 'no-webxr' | 'no-headset';
}

type Asked = Pick<XRSystem, 'isSessionSupported'>;

/** `secure`: the page came over HTTPS or from this machine, else browsers keep headsets from it. */
export async function headsetOffer(secure: boolean, xr: Asked | undefined): Promise<HeadsetOffer> {
  if (!secure) return { modes: [], obstacle: 'insecure' };
  if (!xr) return { modes: [], obstacle: 'no-webxr' };
  const asked: HeadsetMode[] = ['immersive-vr', 'immersive-ar'];
  const answers = await Promise.all(asked.map((mode) => xr.isSessionSupported(mode).catch(() => false)));
  const modes = asked.filter((_, i) => answers[i]);
  return { modes, obstacle: modes.length > 0 ? 'none' : 'no-headset' };
}
