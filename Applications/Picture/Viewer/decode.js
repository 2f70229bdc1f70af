// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces as ViewerMesh.cxx writes them: varints, compressed, in base64.

async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function bytesOf(element) {
  const text = atob(element.textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) {
    bytes[i] = text.charCodeAt(i);
  }
  return inflate(bytes);
}

class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.position = 0;
  }

  varint() {
    let value = 0;
    let shift = 0;
    let byte = 0;
    do {
      byte = this.bytes[this.position++];
      value |= (byte & 0x7f) << shift;
      shift += 7;
    } while (byte & 0x80);
    return value >>> 0;
  }

  signed() {
    const value = this.varint();
    return (value >>> 1) ^ -(value & 1);
  }

  /** Coordinates along x, then y, then z: steps of the grid, as differences from point to point. */
  points(count, grid) {
    const points = new Float32Array(3 * count);
    for (let axis = 0; axis < 3; ++axis) {
      let coordinate = 0;
      for (let i = 0; i < count; ++i) {
        coordinate += this.signed();
        points[3 * i + axis] = grid.origin[axis] + grid.step * coordinate;
      }
    }
    return points;
  }

  /** Corners, each as its distance from the next point that no triangle before uses. */
  triangles(count) {
    const corners = new Uint32Array(3 * count);
    let next = 0;
    for (let i = 0; i < corners.length; ++i) {
      const back = this.varint();
      corners[i] = next - back;
      next += back === 0 ? 1 : 0;
    }
    return corners;
  }

  distances(count) {
    this.position += count;
    return this.bytes.subarray(this.position - count, this.position);
  }
}

/** The pieces of a surface: { parts, points, triangles, distances }, distances null if there are none. */
export function decodeSurface(bytes, surface, grid) {
  const reader = new Reader(bytes);
  return surface.pieces.map((piece) => ({
    parts: piece.parts,
    points: reader.points(piece.points, grid),
    triangles: reader.triangles(piece.triangles),
    distances: surface.hasDistances ? reader.distances(piece.points) : null,
  }));
}
