// SPDX-License-Identifier: Apache-2.0
// Unobtrusive marks that give the room scale: a grid on the floor, and a small pyramid at each sensor.
import * as THREE from 'three';

const gridRadius_m = 8;
const gridColor = new THREE.Color('#2a3441');
const gridDepth_m = 0.02; // below the floor, so that the grid is visible only where no sensor sees the floor

/** Lines a metre apart that fade out with distance from the origin. */
export function floorGrid(background: THREE.Color): THREE.LineSegments {
  const positions: number[] = [];
  const colors: number[] = [];
  const add = (x: number, z: number) => {
    positions.push(x, -gridDepth_m, z);
    const fade = Math.min(1, Math.hypot(x, z) / gridRadius_m);
    colors.push(...gridColor.clone().lerp(background, fade).toArray());
  };
  for (let line = -gridRadius_m; line <= gridRadius_m; line++) {
    for (let piece = -gridRadius_m; piece < gridRadius_m; piece++) {
      add(line, piece);
      add(line, piece + 1);
      add(piece, line);
      add(piece + 1, line);
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(colors, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ vertexColors: true }));
}

/** In the sensor's frame: x right, y down, z forward. */
export function sensorMark(color: string): THREE.LineSegments {
  const [w, h, d] = [0.055, 0.045, 0.09];
  const corners = [
    [-w, -h, d],
    [w, -h, d],
    [w, h, d],
    [-w, h, d],
  ] as const;
  const positions = corners.flatMap((corner, i) => [0, 0, 0, ...corner, ...corner, ...corners[(i + 1) % 4]!]);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color }));
}
