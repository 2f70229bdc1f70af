// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Where two surfaces are farthest apart, as in FarthestPoints.cxx.

const COUNT = 10;
const LEAST_SEPARATION = 0.05; // of the diagonal
const LEAST_SHOWN = 0.0001; // mm
const DECIMALS = 4;

const at = (points, index) => [points[3 * index], points[3 * index + 1], points[3 * index + 2]];
const minus = (a, b) => a.map((value, axis) => value - b[axis]);
const isSame = (a, b) => a.every((value, axis) => value === b[axis]);

/** The unit normal of a triangle, or of all that have a corner there, weighted by area; zero if they have none. */
function outwardAt({ points, triangles }, position, triangle) {
  const sum = [0, 0, 0];
  const isCorner = (point) => points[3 * point] === position[0] && isSame(at(points, point), position);
  for (let i = 0; i < triangles.length; i += 3) {
    const corners = triangles.subarray(i, i + 3);
    if (triangle === undefined ? corners.some(isCorner) : i === 3 * triangle) {
      const [a, b, c] = Array.from(corners, (point) => at(points, point));
      const [u, v] = [minus(b, a), minus(c, a)];
      sum[0] += u[1] * v[2] - u[2] * v[1];
      sum[1] += u[2] * v[0] - u[0] * v[2];
      sum[2] += u[0] * v[1] - u[1] * v[0];
    }
  }
  const length = Math.hypot(...sum) || 1;
  return sum.map((value) => value / length);
}

/** The farthest point of a surface that is not near those found; with a distance of 0 if there is none. */
function farthestOf(surface, distances, isFree) {
  let found = { distance: 0 };
  for (let i = 0; i < distances.length; ++i) {
    if (distances[i] > found.distance && isFree(at(surface.points, i))) {
      found = { distance: distances[i], position: at(surface.points, i), surface };
    }
  }
  return found;
}

/** Rounded down, so that none looks larger than its bound. */
function lengthText(distance) {
  const scale = 10 ** DECIMALS;
  return distance < LEAST_SHOWN ? `< ${LEAST_SHOWN}` : (Math.floor(distance * scale) / scale).toFixed(DECIMALS);
}

/** @param axes Letters of both ends of each axis, as the viewer takes them. */
function positionText(position, axes) {
  const text = (value, [low, high]) =>
    low === '' ? value.toFixed(1) : `${value < 0 ? low : high} ${Math.abs(value).toFixed(1)}`;
  return position.map((value, axis) => text(value, axes[axis])).join(', ');
}

/**
 * @param surfaces Two. @param distances mm, of the points of each; empty: none.
 * @param peaks Positions within triangles: { distance, position, surface, triangle }.
 * @param diagonal mm @param axes As of positionText().
 * @returns The list that the viewer takes, the largest first. Of points closer together than a twentieth of the diagonal only that of
 *   the largest distance is listed.
 */
export function farthestPoints(surfaces, distances, peaks, diagonal, axes) {
  const found = [];
  const separation = LEAST_SEPARATION * diagonal;
  const isFree = (point) => found.every(({ position }) => Math.hypot(...minus(point, position)) >= separation);
  while (found.length < COUNT) {
    const ofPoints = surfaces.map((surface, side) => farthestOf(surface, distances[side], isFree));
    const candidates = [...ofPoints, ...peaks.filter(({ position }) => isFree(position))];
    const next = candidates.reduce((a, b) => (b.distance > a.distance ? b : a));
    if (!(next.distance > 0)) {
      break;
    }
    found.push(next);
  }
  return found.map(({ distance, position, surface, triangle }) => ({
    distance: lengthText(distance),
    where: positionText(position, axes),
    position,
    outward: outwardAt(surface, position, triangle),
  }));
}
