// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the viewer of pages (Applications/Picture/Viewer) shows of two surfaces.
import { farthestPoints } from './farthest.js';

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
/** Letters at both ends of each axis, as in FarthestPoints.cxx. */
const AXES = [['', 'x'], ['', 'y'], ['', 'z']];
const AXES_OF_PATIENT = [['R', 'L'], ['A', 'P'], ['I', 'S']];

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

/** Of all points of several surfaces. */
function boundsOf(lists) {
  const bounds = [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];
  for (const points of lists) {
    for (let i = 0; i < points.length; ++i) {
      const axis = i % 3;
      bounds[2 * axis] = Math.min(bounds[2 * axis], points[i]);
      bounds[2 * axis + 1] = Math.max(bounds[2 * axis + 1], points[i]);
    }
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

/** Distances as steps of the range, rounded down, so that none looks larger than its bound; none: null. */
function stepsOf(distances, range) {
  const step = (value) => Math.min(STEPS, Math.floor((STEPS * value) / range)) || 0;
  return distances.length > 0 ? Uint8Array.from(distances, step) : null;
}

/**
 * @param surfaces Two. @param names What the captions call them.
 * @param distances mm, of the points of each surface; empty: none. @param peaks As of farthestPoints().
 * @param isOfPatient Whether the axes are those of patients, LPS.
 * @returns The scene, and the pieces of both surfaces.
 */
export function makeScene({ surfaces, names, distances, peaks = [], isOfPatient }) {
  const range = rangeOf(distances);
  const bounds = boundsOf(surfaces.map(({ points }) => points));
  const view = viewOf(bounds);
  const axes = isOfPatient ? AXES_OF_PATIENT : AXES;
  const colors = Array.from({ length: STEPS + 1 }, (_, step) => colorAt(step));
  const scene = {
    bounds,
    view,
    axes,
    parts: [{ name: 'surface', color: null }],
    distances: { range, colors, threshold: 0 },
    farthest: farthestPoints(surfaces, distances, peaks, 2 * view.radius, axes),
    surfaces: surfaces.map((surface, side) => ({ caption: `${names[side]}: ${counted(surface)} triangles` })),
  };
  const pieces = surfaces.map(({ points, triangles }, side) => [
    { parts: [0], points: new Float32Array(points), triangles, distances: stepsOf(distances[side], range) },
  ]);
  return { scene, pieces };
}
