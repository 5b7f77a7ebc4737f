// SPDX-License-Identifier: Apache-2.0
// What is loaded when somebody speaks or wants to speak.
import { Voice, type VoiceEvents, type VoiceParts } from './voice';
import { VoiceControls } from './voice_controls';

export { volumeSlider } from './voice_controls';

export function openVoice(parts: VoiceParts, events: VoiceEvents): Promise<Voice> {
  return Voice.open(parts, events);
}

export function voiceControls(voice: Voice): VoiceControls {
  return new VoiceControls(voice);
}
