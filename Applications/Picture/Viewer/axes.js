// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The axes in the corner of a view, with letters at their ends.
import { shape } from './overlay.js';

const SIZE = 30; // CSS pixels from the middle to a letter
const HIDDEN = 0.6; // an axis shorter than this, seen from its end, has no letters

/**
 * @param letters Of each axis, at its lower and its upper end; an empty one is not drawn.
 * @param middle CSS pixels in the stage. @param axes Unit vectors of the view: { right, up }.
 */
export function drawAxes(overlay, letters, middle, { right, up }) {
  letters.forEach((ends, axis) => {
    const [x, y] = [right[axis], -up[axis]];
    const isSeen = Math.hypot(x, y) > HIDDEN;
    ends.forEach((letter, end) => {
      const sign = end === 0 ? -1 : 1;
      if (letter && isSeen) {
        const at = (length) => middle.map((value, i) => value + sign * length * [x, y][i]);
        const [[x1, y1], [x2, y2], [tx, ty]] = [at(0), at(SIZE - 10), at(SIZE)];
        shape(overlay, 'line', { x1, y1, x2, y2, class: 'axis' });
        shape(overlay, 'text', { x: tx, y: ty, dy: '0.35em', class: 'letter' }, letter);
      }
    });
  });
}
