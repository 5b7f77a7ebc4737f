// SPDX-License-Identifier: Apache-2.0
// The English texts about the recordings that a hub keeps.

export const recordingTexts = {
  none: 'This room has no recordings yet.',
  states: {
    whole: '',
    running: 'It is being recorded.',
    damaged: 'Damaged.',
    unreadable: 'Damaged: it cannot be read.',
  },
  length: (length: string) => `${length} min`,
  size: (megabytes: string) => `${megabytes} MB`,
  sensors: (count: number) => (count === 1 ? '1 sensor' : `${count} sensors`),
  by: (name: string) => `by ${name}`,
  changed: (date: string) => `changed ${date}`,
  unread: (count: number) => `The hub is still reading ${count === 1 ? 'one more file' : `${count} more files`}.`,
  leftOut: (count: number) => `${count === 1 ? 'One older file is' : `${count} older files are`} not in this list.`,
  showAll: (count: number) => `Show all ${count}`,
  download: 'Download',
  rename: 'Rename',
  remove: 'Delete',
  reallyRemove: 'Delete for good?',
  of: (what: string, name: string) => `${what}: ${name}`,
  newName: 'New name',
  save: 'Save',
  cancel: 'Cancel',
  removed: (name: string) => `${name} is deleted.`,
  renamed: (name: string) => `It is called ${name} now.`,
};
