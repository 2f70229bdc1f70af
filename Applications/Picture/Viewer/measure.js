// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The distance between two points of the surfaces, drawn over the canvas.

import { shape } from './overlay.js';

const STILL = 4; // CSS pixels: a pointer that moves farther turns the view

export class Measure {
  /** @param pickAt Gives what pick.js finds at a position of the stage, or null. */
  constructor(stage, overlay, output, pickAt) {
    this.overlay = overlay;
    this.output = output;
    this.points = [];
    this.isOn = false;
    let pressed = null;
    const position = (event) => {
      const box = stage.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    stage.addEventListener('pointerdown', (event) => {
      pressed = event.isPrimary && event.button === 0 ? position(event) : null;
    });
    stage.addEventListener('pointerup', (event) => {
      const at = position(event);
      if (this.isOn && pressed && Math.hypot(at[0] - pressed[0], at[1] - pressed[1]) <= STILL) {
        this.add(pickAt(at)?.point);
      }
      pressed = null;
    });
  }

  switch(isOn) {
    this.isOn = isOn;
    this.points = [];
    this.tell();
  }

  add(point) {
    if (point) {
      this.points = this.points.length === 2 ? [point] : [...this.points, point];
      this.tell();
      this.onChange();
    }
  }

  tell() {
    const sentences = ['Click a point of a surface.', 'Click a second point.'];
    this.output.textContent = this.isOn ? sentences[this.points.length] || `${this.length()} mm` : '';
  }

  length() {
    const [a, b] = this.points;
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]).toFixed(2);
  }

  /** @param projections For each view that is shown, a function from space to the stage. */
  draw(projections) {
    for (const project of projections) {
      const at = this.points.map(project);
      if (at.length === 2) {
        const [[x1, y1], [x2, y2]] = at;
        shape(this.overlay, 'line', { x1, y1, x2, y2, class: 'measured' });
        shape(this.overlay, 'text', { x: (x1 + x2) / 2 + 8, y: (y1 + y2) / 2 - 8 }, `${this.length()} mm`);
      }
      at.forEach(([cx, cy]) => shape(this.overlay, 'circle', { cx, cy, r: 4 }));
    }
  }
}
