// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the viewer of pages (Applications/Picture/Viewer) shows of two surfaces.

/** Colors of distances from 0 to the end of the range, as in DistanceColors.cxx. */
const COLORS = [
  [251, 246, 230],
  [254, 209, 148],
  [254, 165, 113],
  [249, 120, 93],
  [229, 80, 100],
  [194, 59, 117],
  [155, 46, 127],
  [117, 33, 129],
  [79, 18, 123],
];
const STEPS = 255;
const MARGIN = 1.06;
const LEAST_RANGE = 0.001; // mm
const MOST = 0.999; // of the points are within the range of colors

function colorAt(step) {
  const at = (step / STEPS) * (COLORS.length - 1);
  const first = Math.min(Math.floor(at), COLORS.length - 2);
  return COLORS[first].map((value, i) => Math.round(value + (at - first) * (COLORS[first + 1][i] - value)));
}

/** mm, the end of the colors; what is not a number is left out. */
function rangeOf(distances) {
  const ends = distances.map((each) => {
    const sorted = Float32Array.from(each).filter((value) => value >= 0).sort();
    return sorted.length > 0 ? sorted[Math.floor(MOST * (sorted.length - 1))] : 0;
  });
  return Number(Math.max(LEAST_RANGE, ...ends).toPrecision(2));
}

function boundsOf(points) {
  const bounds = [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    const axis = i % 3;
    bounds[2 * axis] = Math.min(bounds[2 * axis], points[i]);
    bounds[2 * axis + 1] = Math.max(bounds[2 * axis + 1], points[i]);
  }
  return bounds;
}

/** From the front of the patient, head up. */
function viewOf(bounds) {
  const half = [0, 1, 2].map((axis) => 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]));
  return {
    center: [0, 1, 2].map((axis) => 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1])),
    toViewer: [0, -1, 0],
    up: [0, 0, 1],
    radius: Math.hypot(...half),
    halfWidth: MARGIN * half[0],
    halfHeight: MARGIN * half[2],
  };
}

const counted = (surface) => (surface.triangles.length / 3).toLocaleString('en-US');

/** @param distances mm, of the points of each surface; empty: none. @returns The scene, and the pieces of both surfaces. */
export function makeScene(before, after, distances) {
  const range = rangeOf(distances);
  const bounds = boundsOf(before.points);
  const piece = ({ points, triangles }, side) => ({
    parts: [0],
    points: new Float32Array(points),
    triangles,
    distances:
      distances[side].length > 0
        ? Uint8Array.from(distances[side], (value) => Math.min(STEPS, Math.round((STEPS * value) / range)))
        : null,
  });
  const colors = Array.from({ length: STEPS + 1 }, (_, step) => colorAt(step));
  const scene = {
    bounds,
    view: viewOf(bounds),
    parts: [{ name: 'surface', color: null }],
    distances: { range, colors },
    surfaces: [
      { caption: `Before: ${counted(before)} triangles` },
      { caption: `After: ${counted(after)} triangles` },
    ],
  };
  return { scene, pieces: [[piece(before, 0)], [piece(after, 1)]] };
}
