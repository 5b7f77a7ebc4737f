// SPDX-License-Identifier: Apache-2.0
// All English texts of the page in one place, for review and translation; those of the tools and marks are in
// mark_texts.ts, those of the console in console_texts.ts.

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
      'Browsers allow headsets only on pages loaded over HTTPS. Start the hub with --tls-self-signed (or put it behind ' +
      'an HTTPS proxy) and open its https:// address; on the hub’s own computer http://localhost works, too.',
    'no-webxr':
      'This browser does not support WebXR. Use the browser of a headset, or Chrome or Edge on a computer.',
    'no-headset': 'No headset is connected to this browser. Open this page in a headset’s own browser, or connect one.',
  },
  help: 'Left stick: walk. Right stick: turn, or push forward to aim at the floor and release to go there. Trigger or pinch: aim and go there.',
};

export const signInTexts = {
  console: 'Console',
  signIn: 'Token',
  signInHelp: 'A token from the hub’s operator. It is kept for this tab only.',
  enter: 'Use it',
  notKept:
    'This browser keeps nothing for this page (cookies are blocked), so the token would be lost at once. Permit it to ' +
    'keep data for this page, or ask for a link.',
};

export const connectionTexts = {
  differentVersion: 'The hub speaks another version of roomcast than this page. Load the page again.',
  noAnswer: (host: string) => `The hub at ${host} does not answer.`,
  stopped: 'The hub has stopped.',
  gone: (host: string, reason: string) =>
    `The connection to the hub at ${host} is gone.${reason ? ` It said: ${reason}` : ''}`,
  elsewhere: 'Continuing at another hub.',
  hungUp: (sentence: string) => `The hub closed the connection: ${sentence || 'it gave no reason.'}`,
  tooSlow: 'This computer or its connection was too slow, so the hub closed the connection.',
  roomFull: 'The room is full.',
  busy: 'This hub is busy.',
  noSuchRoom: 'The hub has no room of that name, or you have no link to it.',
  severalRooms: 'This hub has several rooms: choose one.',
  needsToken: 'This room requires a token. Ask its owner for a link.',
  tokenExpired: 'Your token has expired. Ask the room’s owner for another link.',
  wrongRoom: 'Your token is for another room.',
  codeUsed: 'This one-time link has been used. Ask for another one.',
  tokenInvalid: 'The hub does not accept this token: another hub made it, or it is for another role.',
  tokenRevoked: 'Your token was revoked by the room’s owner.',
};

export const panelTexts = {
  wrong: 'Problems',
  closePanel: 'Close the panel',
  openPanel: 'Open the panel',
  phases: { joined: 'live', recorded: 'recording', connecting: 'connecting', waiting: 'not connected', broken: 'stopped' },
  received: { label: 'MB/s', title: 'Received in all, 10⁶ bytes per second' },
  shown: { label: 'fps', title: 'Frame sets shown per second' },
  latency: { label: 'latency', title: 'From capture to screen, median of the last second, ± error of the clock' },
  sensors: 'Sensors',
  noSensors: 'none yet',
  gone: 'gone',
  coarse: 'coarse',
  coarseTitle: 'Your connection takes no more: this sensor sends you coarser pictures, and fewer',
  showSensor: (name: string) => `Show sensor ${name}`,
  people: 'People',
  person: (id: number) => `viewer ${id}`,
  you: (name: string) => `${name} (you)`,
  follow: 'Follow',
  followWhom: (name: string) => `Follow ${name}`,
  rooms: 'Rooms',
  inRoom: (sensors: number, people: number) =>
    `${sensors} ${sensors === 1 ? 'sensor' : 'sensors'}, ${people} ${people === 1 ? 'person' : 'people'}`,
  needsToken: 'with a link only',
  drawnAs: 'Drawn as',
  modes: {
    blend: { label: 'Blended', title: 'The surfaces of all sensors, mixed' },
    mesh: { label: 'Surfaces', title: 'The nearest surface of any sensor' },
    points: { label: 'Points', title: 'A square for each reading' },
    still: { label: 'Still', title: 'What stands still, fused from all sensors: the room without people' },
  },
  drawing: {
    notBlended: 'This machine is too slow to blend them: the nearest surface is drawn.',
    someSensors: (shown: number, wanted: number) => `${shown} of ${wanted} sensors are drawn, those that see most from here.`,
  },
  tryAgain: 'Try again',
  theme: 'Colours',
  themes: { auto: 'Auto', dark: 'Dark', light: 'Light' },
  moving: 'Moving around',
  keys: [
    ['drag', 'turn around the middle'],
    ['right drag', 'shift'],
    ['wheel', 'nearer, farther'],
    ['W A S D', 'walk (Shift: faster)'],
    ['arrows', 'turn, look up and down'],
    ['Q E', 'down, up'],
    ['double click', 'go there'],
    ['press and hold, L', 'point'],
    ['G', 'go to what is ahead'],
    ['R', 'back to the start'],
    ['F', 'full screen'],
    ['V', 'hold to speak, where you chose that'],
    ['1 finger', 'look around'],
    ['2 fingers', 'shift and zoom'],
    ['double tap', 'go there'],
    ['press and hold', 'point'],
    ['stick', 'walk'],
  ] as const,
  running: 'Running this room',
};

export const qualityTexts = {
  title: 'Quality',
  choices: { auto: 'As this machine can', best: 'Best', fine: 'Fine', medium: 'Medium', coarse: 'Coarse' },
  readings: (step: number) => (step === 1 ? 'Every reading' : `Every ${step}${['nd', 'rd'][step - 2] ?? 'th'} reading`),
  blended: 'blended',
  nearest: 'the nearest surface',
  points: 'points',
  still: 'The model of what stands still',
  sensors: (shown: number, wanted: number) =>
    shown < wanted ? `${shown} of ${wanted} sensors` : wanted === 1 ? 'the only sensor' : `all ${wanted} sensors`,
  screen: (ratio: number) => `${(100 * ratio).toFixed(0)} % of the screen’s resolution`,
};

export const voiceTexts = {
  title: 'Voice',
  microphone: 'Microphone',
  off: 'Your microphone is off.',
  sending: 'The others hear you.',
  waits: 'The others hear you when you speak.',
  recorded: 'This room is being recorded, with what is said.',
  alone: 'You play this recording alone: nobody hears you.',
  notConnected: 'Nobody hears you while this page is not connected to the hub.',
  heldBack: 'The others hear you while you hold V or the button.',
  awaitsGesture: 'Click anywhere or press a key to hear the others: browsers ask for that.',
  insecure:
    'Browsers permit voice only on pages loaded over HTTPS. Start the hub with --tls-self-signed and open its https:// ' +
    'address; on the hub’s own computer http://localhost works, too.',
  noDecoder: 'This browser cannot decode voice (WebCodecs), so you hear nobody. Use a recent Chrome, Edge or Firefox.',
  noEncoder: 'This browser can play voices but not encode yours (WebCodecs). Use a recent Chrome, Edge or Firefox to speak.',
  mayNotSpeak: 'The owner of this room lets you listen, not speak.',
  muted: 'An admin has muted you: nobody hears you.',
  denied: 'The browser does not let this page use the microphone. Permit it in the settings beside the address, and try again.',
  noMicrophone: 'No microphone was found. Connect one, and try again.',
  inUse: 'The microphone cannot be opened; another program may be using it.',
  lost: 'The microphone is gone. Connect it, or choose another one, and turn it on again.',
  failed: (reason: string) => `The microphone does not work: ${reason}`,
  notLoaded: 'Voice could not be loaded. Press the button to try again, or load the page again.',
  level: 'Loudness of your microphone',
  talk: 'When you are heard',
  modes: { voice: 'When I speak', push: 'While I hold V' },
  hold: 'Hold to speak (V)',
  device: 'Your microphone',
  hear: 'Hear the others',
  volumeOf: (name: string) => `Volume of ${name}`,
  speaks: 'speaks',
  isMuted: 'muted',
  records: 'records',
  recordsVoices: 'records, with voices',
  isHeard: 'is heard', // the microphone of a sensor
};

export const hintTexts = {
  mouse: 'Drag to turn, scroll to come nearer, walk with W A S D or turn with the arrow keys. Double click to go there.',
  touch: 'Drag with one finger to look around, walk with the stick. Double tap to go there.',
};

export const followTexts = {
  following: (name: string) => `You see what ${name} sees.`,
  stop: 'Stop (Esc)',
  left: (name: string) => `${name} has left. You stay where you are.`,
};

export const placesTexts = {
  title: 'Places',
  fromAbove: 'Look from above',
  asSensor: (name: string) => `As ${name} sees it`,
  name: 'Name of where you are now',
  keep: 'Keep it',
  keepForAll: 'For everybody',
  keptForAll: (name: string) => `“${name}” is a place of this room now: everybody can go there.`,
  notKeptForAll: 'It needs a name, and a connection to the hub.',
  by: (author: string) => `named by ${author}`,
  remove: (name: string) => `Remove the place ${name} for everybody`,
  kept: (name: string) => `“${name}” is kept in this browser. To give it to others, share the view.`,
  notKept: 'It needs a name, and no more than 50 places are kept.',
  forget: (name: string) => `Forget the place ${name}`,
};

export const nameTexts = {
  name: 'Your name, as the others see it',
  take: 'Take it',
  change: 'Change your name',
};

export const mapTexts = {
  title: 'From above',
  you: 'you',
  help: 'Click to go there.',
  label: (sensors: number, people: number) =>
    `The room from above: ${sensors} ${sensors === 1 ? 'sensor' : 'sensors'}, ` +
    `${people === 0 ? 'no other people' : people === 1 ? 'another person' : `${people} other people`}, and you`,
};

export const viewTexts = {
  title: 'Your view',
  reset: 'To the start (R)',
  share: 'Share this view',
  address: 'Address of this view',
  copied: 'Copied. The address opens this room where you are now.',
  copyByHand: 'Copy the address above: it opens this room where you are now.',
  fullScreen: 'Full screen (F)',
  leaveFullScreen: 'Leave full screen (F)',
  noFullScreen: 'This browser does not let the page fill the screen.',
  save: 'Take a picture',
  saved: (name: string) => `Saved as ${name}.`,
  notSaved: 'No picture can be taken now: the room is not drawn on this screen.',
  omitsToken: 'Your token is not in it: whoever needs one to enter also needs a link of their own.',
};

export const gyroscopeTexts = {
  button: 'Look by turning the phone',
  insecure: 'Browsers tell how a phone is turned only to pages loaded over HTTPS.',
  denied: 'The browser does not tell this page how the phone is turned. Permit it in the settings, and try again.',
  none: 'This device does not tell how it is turned.',
};

export const progressTexts = {
  title: 'Loading the room',
  connecting: 'Connecting to the hub …',
  waiting: (shown: number, all: number) => `Pictures of ${shown} of ${all} sensors are here …`,
};

export const placementTexts = {
  moved: 'moved',
  movedTitle: 'It was moved and is being aligned again.',
  unplaced: 'not placed',
  unplacedTitle: 'being aligned',
  unverified: 'not verified',
  unverifiedTitle: 'Shown at its stored pose, which has not been confirmed yet.',
  aligned: 'aligned',
  error: (error_mm: number) => `± ${error_mm} mm`,
  alignedTitle: 'Aligned automatically. Expected error 2.5 m in front of it.',
};

export const problemTexts = {
  noWebGl: 'This browser cannot draw in 3D (WebGL 2 is missing or switched off).',
  contextLost: 'The graphics card has stopped. If the room does not come back, load the page again.',
  noDecoder: (reason: string) =>
    `The depth decoder could not be loaded (${reason}). Nothing can be shown; load the page again.`,
  decoderStopped: (reason: string) => `The decoder has stopped (${reason}). Load the page again.`,
  noColor: 'This browser cannot decode VP9 (WebCodecs): depth is shown without colour.',
  noColorInsecure:
    'Browsers decode colour only on pages loaded over HTTPS: depth is shown without it. Start the hub with ' +
    '--tls-self-signed and open its https:// address; on the hub’s own computer http://localhost works, too.',
  noPlayback: 'The controls of the recording could not be loaded.',
  noStudy: (reason: string) => `The study has stopped: ${reason}`,
  noConsole: 'The console could not be loaded. Press its button to try again, or load the page again.',
  connecting: (hub: string) => `Connecting to ${hub} …`,
  tryingIn: (seconds: number) => `Trying again in ${seconds} s.`,
  trying: 'Trying again.',
  noSensors: (hub: string) => `No sensor is in the room yet. To add one: roomcast sensor --source sim --hub ${hub}`,
  allGone: 'All sensors are gone; the last pictures are shown in grey.',
  gone: (name: string) => `Sensor ${name} is gone; its last picture is shown in grey.`,
  heldBack: (names: readonly string[]) =>
    `Your connection is too slow for all sensors: now and then only comes a picture of ${names.join(', ')}.`,
  coarse: 'Your connection is slow, so some sensors send you coarser pictures and fewer of them.',
  silent: (name: string) => `Sensor ${name} is silent.`,
  silentFor: (seconds: number) => `Its last picture is ${seconds} s old.`,
  sensor: (name: string, problem: string) => `Sensor ${name}: ${problem}`,
  moved: (name: string, why: string) =>
    `Sensor ${name} was moved: it is shown where it was until it is aligned again.${why}`,
  unverified: (name: string, why: string) =>
    `Sensor ${name} is shown at its stored pose, which has not been confirmed yet.${why}`,
  unplaced: (name: string, why: string) =>
    `Sensor ${name} is not placed yet: ${why} is shown at a provisional place.`,
  unplacedOnes: (names: string[]) =>
    `Sensors ${new Intl.ListFormat('en').format(names)} are not placed yet: they are shown at provisional places.`,
};
