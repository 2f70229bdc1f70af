// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/** The parameters of the line at which it meets the triangles of a piece (Moeller and Trumbore). */
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
        yield (vx * qx + vy * qy + vz * qz) / determinant;
      }
    }
  }
}

/**
 * The first point of the visible pieces of a surface on a line, or null.
 * @param line Its ends, from near to far. @param isKept Whether a point is not cut away.
 */
export function pick(surface, [start, end], isKept) {
  const direction = end.map((value, axis) => value - start[axis]);
  let nearest = Infinity;
  let found = null;
  for (const piece of surface.visiblePieces()) {
    for (const t of hits(piece, start, direction)) {
      const point = start.map((value, axis) => value + t * direction[axis]);
      if (t >= 0 && t < nearest && isKept(point)) {
        nearest = t;
        found = point;
      }
    }
  }
  return found;
}
