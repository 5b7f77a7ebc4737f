// SPDX-License-Identifier: Apache-2.0
// The limits of roomcast.v1 that a viewer enforces or obeys; docs/spec/wire.md §4, roomcast/wire/limits.h.

export const maxFrameBytes = 2 * 1024 * 1024; // header and payload
export const maxControlFromClientBytes = 16 * 1024;
export const maxControlFromHubBytes = 256 * 1024;
export const maxAudioBytes = 1400; // header and payload
export const maxAudioPayloadBytes = 1275;
export const maxSensors = 32;
export const maxViewers = 2048;
export const maxPosesPerMessage = 512;
export const maxNameBytes = 64;
export const maxImageSide = 8192;
export const minDepthSide = 16;
export const maxDepthSide = 4096;
export const maxFps = 240;
export const maxPosition_m = 10_000;
export const maxLayer = 7;
export const maxMarks = 500; // in a room
export const maxMarkPoints = 512; // of one sketch
export const maxMarkTextBytes = 280;
