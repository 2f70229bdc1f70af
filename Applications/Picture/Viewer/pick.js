// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/** Where a line meets the triangles of a piece: its parameter, the triangle, and the weights of its corners (Moeller and Trumbore). */
function* hits(piece, start, direction) {
  const { points, triangles } = piece;
  const [dx, dy, dz] = direction;
  for (let i = 0; i < triangles.length; i += 3) {
    const a = 3 * triangles[i];
    const b = 3 * triangles[i + 1];
    const c = 3 * triangles[i + 2];
    const ux = points[b] - points[a];
    const uy = points[b + 1] - points[a + 1];
    const uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a];
    const vy = points[c + 1] - points[a + 1];
    const vz = points[c + 2] - points[a + 2];
    const px = dy * vz - dz * vy;
    const py = dz * vx - dx * vz;
    const pz = dx * vy - dy * vx;
    const determinant = ux * px + uy * py + uz * pz;
    const sx = start[0] - points[a];
    const sy = start[1] - points[a + 1];
    const sz = start[2] - points[a + 2];
    const u = (sx * px + sy * py + sz * pz) / determinant;
    if (u >= 0 && u <= 1) {
      const qx = sy * uz - sz * uy;
      const qy = sz * ux - sx * uz;
      const qz = sx * uy - sy * ux;
      const v = (dx * qx + dy * qy + dz * qz) / determinant;
      if (v >= 0 && u + v <= 1) {
        yield { t: (vx * qx + vy * qy + vz * qz) / determinant, triangle: i, weights: [1 - u - v, u, v] };
      }
    }
  }
}

/** Where a line meets the visible pieces of a surface, as fractions of its length. */
export function depths(surface, [start, end]) {
  const direction = end.map((value, axis) => value - start[axis]);
  return surface.visiblePieces().flatMap((piece) => [...hits(piece, start, direction)].map(({ t }) => t));
}

/** The distance at a position of a triangle, in steps of the range, or null. */
function distanceAt({ distances, triangles }, triangle, weights) {
  return distances && weights.reduce((sum, weight, corner) => sum + weight * distances[triangles[triangle + corner]], 0);
}

/**
 * The first point of the visible pieces of a surface on a line with its distance to the other surface, or null.
 * @param line Its ends, from near to far. @param isKept Whether a point is not cut away.
 */
export function pick(surface, [start, end], isKept) {
  const direction = end.map((value, axis) => value - start[axis]);
  let nearest = Infinity;
  let found = null;
  for (const piece of surface.visiblePieces()) {
    for (const { t, triangle, weights } of hits(piece, start, direction)) {
      const point = start.map((value, axis) => value + t * direction[axis]);
      if (t >= 0 && t < nearest && isKept(point)) {
        nearest = t;
        found = { point, distance: distanceAt(piece, triangle, weights) };
      }
    }
  }
  return found;
}
