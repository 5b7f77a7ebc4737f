// SPDX-License-Identifier: Apache-2.0
// IDs of the people who play the same recording, beyond those of the people and microphones in it. By its ID it is known
// whether a voice is of the recording or of somebody who is here now.

const firstFellow = 0xc000_0000;
const firstSilent = 0xe000_0000; // of those who cannot be heard

/** By the ID that the hub has given to the viewer. */
export function fellowOf(viewer: number): number {
  return firstFellow + viewer;
}

/** Of somebody without a viewer's ID, by the ID among those who play the recording. */
export function silentFellowOf(id: number): number {
  return firstSilent + id;
}

export function isFellow(speaker: number): boolean {
  return speaker >= firstFellow;
}
