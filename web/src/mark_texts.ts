// SPDX-License-Identifier: Apache-2.0
// The English texts of the tools, of marks and of guiding; all others are in texts.ts.

export const toolTexts = {
  title: 'Tools',
  tools: {
    point: { label: 'Point', help: 'Press on a surface and hold: the others see where.' },
    note: { label: 'Note', help: 'Press on a surface to pin a note there.' },
    sketch: { label: 'Draw', help: 'Draw on a surface with the button down, or with one finger.' },
    measure: { label: 'Measure', help: 'Press where the distance begins.' },
  },
  list: 'Marks',
  listHelp: 'Notes, drawings and distances that people left in the room',
};

export const markTexts = {
  nothingThere: 'There is no surface that one could mark.',
  nothingDrawn: 'There was no surface to draw on.',
  from: 'from here',
  measureTo: 'Press where the distance ends.',
  measured: (distance: string) => `It is ${distance}.`,
  leaveIt: 'Leave it for everybody',
  words: 'Note for everybody in the room',
  leave: 'Leave it',
  cancel: 'Cancel',
  noWords: 'Write something first.',
  tooManyWords: (bytes: number) => `That is too long: a note has at most ${bytes} letters, fewer with accents.`,
  left: 'Everybody sees it until it is removed.',
  undo: 'Undo',
  refused: (sentence: string) => `The hub did not take it: ${sentence}.`,
  notConnected: 'There is no connection to the hub. Try again when it is back.',
  notLoaded: 'The tools could not be loaded. Press the button again, or load the page again.',
  listTitle: 'Marks in the room',
  show: 'Show them in the room',
  none: 'Nobody has left anything yet.',
  sketch: 'Drawing',
  distance: (distance: string) => `Distance, ${distance}`,
  somebody: 'somebody',
  remove: (title: string) => `Remove: ${title}`,
  removeAll: (count: number) => `Remove these ${count}`,
  reallyRemove: (count: number) => `Really remove ${count} marks for everybody?`,
};

export const guideTexts = {
  guide: 'Show everybody around',
  guiding: 'Everybody sees what you see, except those who move by themselves.',
  stop: 'Stop (Esc)',
  guided: (name: string) => `${name} shows everybody around. Move, or press Escape, to look by yourself.`,
  ended: (name: string) => `${name} no longer shows everybody around. You stay where you are.`,
};
