// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
import vtkPlane from '@kitware/vtk.js/Common/DataModel/Plane';

const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

const scaled = (vector, factor) => vector.map((value) => factor * value);
const along = (point, vector, length) => point.map((value, axis) => value + length * vector[axis]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Half the length of a box along a direction. */
function halfLength(bounds, direction) {
  return [0, 1, 2].reduce(
    (sum, axis) => sum + 0.5 * (bounds[2 * axis + 1] - bounds[2 * axis]) * Math.abs(direction[axis]),
    0
  );
}

/**
 * Planes that cut surfaces: the clipping plane, and the divider between before and after. They keep their
 * identity when they move, because a mapper with another plane would upload its surface again.
 */
export class Planes {
  constructor(view, bounds) {
    this.view = view;
    this.bounds = bounds;
    this.clipping = vtkPlane.newInstance();
    this.divider = { before: vtkPlane.newInstance(), after: vtkPlane.newInstance() };
    this.cut = { along: 'none', at: 0.5, isFlipped: false };
    this.dividedAt = 0.5; // of the width of the view
  }

  /** The planes of a surface, 'before' or 'after'. */
  of(side) {
    return [
      ...(this.cut.along === 'none' ? [] : [this.clipping]),
      ...(this.view.mode === 'divider' ? [this.divider[side]] : []),
    ];
  }

  /** To the settings and the camera. */
  move() {
    this.moveClipping();
    const { right } = this.view.axes();
    const offset = (2 * this.dividedAt - 1) * this.view.camera.getParallelScale() * this.view.aspect();
    const origin = along(this.view.camera.getFocalPoint(), right, offset);
    this.divider.before.set({ origin, normal: scaled(right, -1) });
    this.divider.after.set({ origin, normal: right });
  }

  moveClipping() {
    const direction = AXES[this.cut.along] || this.view.axes().forward;
    const middle = [0, 1, 2].map((axis) => 0.5 * (this.bounds[2 * axis] + this.bounds[2 * axis + 1]));
    const origin = along(middle, direction, (2 * this.cut.at - 1) * halfLength(this.bounds, direction));
    this.clipping.set({ origin, normal: scaled(direction, this.cut.isFlipped ? -1 : 1) });
  }

  /** Whether a point of a surface is on the side of its planes that is drawn. */
  keep(side, point) {
    return this.of(side).every((plane) => dot(plane.getNormal(), along(point, plane.getOrigin(), -1)) >= 0);
  }
}
