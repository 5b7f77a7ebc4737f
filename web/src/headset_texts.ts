// SPDX-License-Identifier: Apache-2.0
// The English texts of the panel in a headset.

export const headsetPanelTexts = {
  open: 'Menu',
  close: 'Close',
  leave: 'Leave the headset',
  start: 'Back to the start',
  narrow: 'Narrow view while walking',
  seated: 'I sit',
  place: 'Place the room',
  placing: 'Point at your floor or a table. The stick turns the room, the trigger puts it down.',
  measure: 'Measure',
  measuring: 'Point with your right hand. The trigger sets two points.',
  leaveIt: 'Leave it for everybody',
  measured: 'Done',
  microphone: (isOn: boolean) => (isOn ? 'Microphone: on' : 'Microphone: off'),
  people: 'Here, and heard by you:',
  alone: 'Nobody else is here.',
  person: (name: string, isSilenced: boolean) => (isSilenced ? `${name} (muted)` : name),
  more: (count: number) => `and ${count} more`,
};
