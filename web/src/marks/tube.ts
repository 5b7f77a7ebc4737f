// SPDX-License-Identifier: Apache-2.0
// A tube along a line of points. three.js has one, too, which would be loaded with the page. Metres.
import { BufferGeometry, Float32BufferAttribute, Vector3 } from 'three';

const sides = 6;

/** Of the way through a point: from the one before to the one after. */
function alongAt(points: readonly Vector3[], i: number): Vector3 {
  const [before, after] = [points[Math.max(0, i - 1)]!, points[Math.min(points.length - 1, i + 1)]!];
  const along = after.clone().sub(before);
  return along.lengthSq() > 0 ? along.normalize() : new Vector3(0, 0, 1);
}

/** Each ring's first direction is the one before, turned as little as the way turns, so that the tube does not twist. */
export function tube(points: readonly Vector3[], radius: number): BufferGeometry {
  const positions: number[] = [];
  const triangles: number[] = [];
  const out = new Vector3();
  points.forEach((point, i) => {
    const along = alongAt(points, i);
    out.addScaledVector(along, -out.dot(along));
    if (out.lengthSq() < 1e-6) out.set(0, 1, 0).addScaledVector(along, -along.y);
    if (out.lengthSq() < 1e-6) out.set(1, 0, 0);
    out.normalize();
    const across = along.clone().cross(out);
    for (let side = 0; side < sides; side++) {
      const angle = (2 * Math.PI * side) / sides;
      const at = point.clone().addScaledVector(out, radius * Math.cos(angle)).addScaledVector(across, radius * Math.sin(angle));
      positions.push(at.x, at.y, at.z);
      if (i === 0) continue;
      const [here, next] = [sides * i + side, sides * i + ((side + 1) % sides)];
      triangles.push(here - sides, next - sides, here, next - sides, next, here);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(positions, 3));
  geometry.setIndex(triangles);
  return geometry;
}
