// SPDX-License-Identifier: Apache-2.0
// The ways in which the room can be drawn.

export const drawModes = ['blend', 'mesh', 'points'] as const;

/**
 * blend: the surfaces of all sensors, mixed by how well each sees what the eye sees, with what they remember behind them;
 * mesh: the nearest surface wins; points: a square for each depth pixel.
 */
export type DrawMode = (typeof drawModes)[number];
