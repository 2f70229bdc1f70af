// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The view of two surfaces, before and after, and the form beside it.
import { drawAxes } from './axes.js';
import { addParts, addFarthest, bind, bindButton, drawLegend, lengthText, show, write } from './controls.js';
import { showUnderCursor } from './hover.js';
import { Measure } from './measure.js';
import { shape } from './overlay.js';
import { depths, pick } from './pick.js';
import { Planes } from './planes.js';
import { Surface } from './surface.js';
import { View } from './view.js';

const SIDES = ['before', 'after'];

export class Viewer {
  /**
   * @param scene As Applications/Picture/README.md describes it.
   * @param piecesOf Gives the pieces of a surface by its index in the scene: { parts, points, triangles, distances } (decode.js).
   */
  constructor(scene, piecesOf) {
    this.scene = scene;
    this.piecesOf = piecesOf;
    this.stage = document.getElementById('viewer-stage');
    this.overlay = document.getElementById('viewer-overlay');
    this.view = new View(this.stage, scene);
    this.planes = new Planes(this.view, scene.bounds);
    this.surfaces = scene.surfaces.map(() => null); // before, then the levels from coarse to fine
    this.level = scene.surfaces.length - 1;
    this.look = { distances: false, threshold: 0, triangles: false, parts: scene.parts.map(() => true) };
    this.chosen = null; // of the points where the surfaces are farthest apart
    this.measure = new Measure(this.stage, this.overlay, document.getElementById('viewer-length'), (at) =>
      this.pickAt(at)
    );
    this.measure.onChange = () => this.drawOverlay();
    this.bindControls();
    showUnderCursor(this.stage, document.getElementById('viewer-value'), (at) => this.valueAt(at));
    this.view.camera.onModified(() => this.follow());
    this.view.watchSize(() => this.update());
  }

  /** Frees what the graphics hardware holds; another viewer may follow. */
  end() {
    this.view.end();
  }

  async load(index) {
    if (!this.surfaces[index]) {
      const pieces = await this.piecesOf(index);
      this.surfaces[index] ||= new Surface(pieces, this.scene, this.view.renderers[index === 0 ? 'before' : 'after']);
    }
  }

  isShown(index) {
    const other = index === 0 ? 'after' : 'before';
    return this.view.mode !== other && (index === 0 || index === this.level);
  }

  /** Whether the level is shown to which the farthest points belong. */
  isLast() {
    return this.level === this.scene.surfaces.length - 1;
  }

  /** Brings surfaces, captions and planes to the settings. */
  update() {
    this.planes.move();
    this.surfaces.forEach((surface, index) => {
      if (surface) {
        surface.clip(this.planes.of(index === 0 ? 'before' : 'after'));
        surface.show({ ...this.look, isVisible: this.isShown(index), isCut: this.planes.cut.along !== 'none' });
      }
    });
    SIDES.forEach((side) => {
      const index = side === 'before' ? 0 : this.level;
      write(`viewer-${side}`, this.scene.surfaces[index].caption);
      show(`viewer-${side}`, this.isShown(index));
    });
    show('viewer-divider', this.view.mode === 'divider');
    show('viewer-legend', this.look.distances);
    this.drawOverlay();
    this.view.render();
  }

  /** What depends on the camera alone. */
  follow() {
    this.planes.move();
    this.drawOverlay();
  }

  drawOverlay() {
    this.overlay.replaceChildren();
    const sides = this.view.mode === 'sides' ? SIDES : [this.view.mode === 'before' ? 'before' : 'after'];
    drawAxes(this.overlay, this.scene.axes, [48, this.stage.clientHeight - 52], this.view.axes());
    const projections = sides.map((side) => (point) => this.view.project(point, this.view.renderers[side]));
    this.measure.draw(projections);
    projections.forEach((project) => {
      if (this.chosen && this.isLast()) {
        const [cx, cy] = project(this.chosen.position);
        shape(this.overlay, 'circle', { cx, cy, r: 14, class: 'chosen' });
        shape(this.overlay, 'text', { x: cx + 19, y: cy - 12 }, `${this.chosen.distance} mm`);
      }
    });
  }

  /** The distance to the other surface under a position of the stage, as text. */
  valueAt(at) {
    const { distances } = this.scene;
    const distance = distances && this.pickAt(at)?.distance;
    if (typeof distance !== 'number') {
      return '';
    }
    const isCapped = distances.isCapped && distance > 254.5;
    return `${lengthText(distances.range, distance)} mm${isCapped ? ' or more' : ''}`;
  }

  pickAt([x, y]) {
    const { mode } = this.view;
    const fraction = x / this.stage.clientWidth;
    const bound = mode === 'divider' ? this.planes.dividedAt : 0.5;
    const side = SIDES.includes(mode) ? mode : SIDES[fraction < bound ? 0 : 1];
    const surface = this.surfaces[side === 'before' ? 0 : this.level];
    const line = this.view.lineAt([x, y], this.view.renderers[side]);
    return surface && pick(surface, line, (point) => this.planes.keep(side, point));
  }

  bindControls() {
    const { scene, planes, look } = this;
    const set = (change) => (element) => {
      change(element);
      this.update();
    };
    bind('viewer-compare', set((element) => this.view.compare(element.value)));
    const divider = bind('viewer-divider', set((element) => (planes.dividedAt = Number(element.value))));
    divider.addEventListener('pointerdown', (event) => event.stopPropagation()); // does not turn the view
    bind('viewer-clip', set((element) => (planes.cut.along = element.value)));
    bind('viewer-clip-at', set((element) => (planes.cut.at = Number(element.value))));
    bind('viewer-clip-flip', set((element) => (planes.cut.isFlipped = element.checked)));
    bind('viewer-triangles', set((element) => (look.triangles = element.checked)));
    bind('viewer-light', set((element) => this.view.turnLight(Number(element.value))));
    bind('viewer-measure', set((element) => this.measure.switch(element.checked)));
    const leave = addFarthest(scene.farthest, (chosen) => this.show(chosen));
    bindButton('viewer-reset', leave);
    addParts(scene.parts, (parts) => {
      look.parts = parts;
      this.update();
    });
    this.bindDistances();
    this.bindLevels();
  }

  /** One of the points of the scene, or the whole. */
  show(chosen) {
    this.chosen = chosen;
    if (chosen) {
      const isKnown = Math.hypot(...chosen.outward) > 0.5;
      const toViewer = isKnown ? chosen.outward : this.view.axes().forward.map((value) => -value);
      this.view.focus(chosen.position, toViewer, this.freeBefore(chosen.position, toViewer));
    } else {
      this.view.reset();
    }
    this.update();
  }

  /** Half the way (mm) from a point to what hides it. The other surface, which lies close by, does not. */
  freeBefore(position, toViewer) {
    const length = 2 * this.scene.view.radius;
    const end = position.map((value, axis) => value + length * toViewer[axis]);
    const { range, tolerance } = this.scene.distances;
    const close = 2 * (tolerance ? Math.min(range, Number(this.chosen.distance) || range) : range);
    const shown = [this.surfaces[0], this.surfaces[this.level]].filter(Boolean);
    const hiding = shown.flatMap((surface) => depths(surface, [position, end])).map((depth) => depth * length);
    return 0.5 * hiding.filter((depth) => depth > close && depth < length).reduce((a, b) => Math.min(a, b), 2 * length);
  }

  bindDistances() {
    const { distances } = this.scene;
    const box = bind('viewer-distances', (element) => {
      this.look.distances = element.checked;
      this.update();
    });
    const slider = bind('viewer-threshold', (element) => {
      this.look.threshold = Number(element.value);
      drawLegend(distances, this.look.threshold);
      this.update();
    });
    show('viewer-distances-line', distances !== null);
    show('viewer-threshold-line', distances !== null);
    if (distances) {
      this.look.distances = box.checked;
      this.look.threshold = distances.threshold;
      slider.value = String(distances.threshold);
      drawLegend(distances, distances.threshold);
    }
  }

  bindLevels() {
    const slider = bind('viewer-level', async (element) => {
      const level = Number(element.value);
      await this.load(level);
      this.level = level;
      show('viewer-farthest-group', this.scene.farthest.length > 0 && this.isLast());
      this.update();
    });
    slider.max = String(this.level);
    slider.value = slider.max;
    show('viewer-level-line', this.level > 1);
  }
}

export function nextFrame() {
  return new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
}

export function canDraw() {
  return Boolean(document.createElement('canvas').getContext('webgl2') && 'DecompressionStream' in window);
}
