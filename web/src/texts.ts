// SPDX-License-Identifier: Apache-2.0
// What the page says, in English: in one place, so that it can be read through as a whole and be translated.

export const headsetTexts = {
  title: 'Headset',
  enterVr: 'Enter VR',
  enterAr: 'Enter with your own room around you',
  leave: 'Leave the headset',
  entering: 'Put the headset on …',
  failed: (reason: string) => `The headset did not start: ${reason}`,
  obstacles: {
    none: '',
    insecure:
      'Browsers keep headsets from pages that did not come over HTTPS. Start the hub with --tls-self-signed (or put it behind ' +
      'an HTTPS proxy) and open its https:// address; on the hub’s own computer http://localhost works, too.',
    'no-webxr': 'This browser does not know WebXR. The browser of a headset does, and so do Chrome and Edge on a computer.',
    'no-headset': 'No headset is connected to this browser. Open this page in a headset’s own browser, or connect one.',
  },
  help: 'Left stick: walk. Right stick: turn, or forward to aim at the floor and let go. Trigger or pinch: aim and go there.',
};
