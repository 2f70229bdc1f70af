// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The view of two surfaces, before and after, and the form beside it.
import { addLegend, addParts, bind, bindButton, show, write } from './controls.js';
import { Measure } from './measure.js';
import { pick } from './pick.js';
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
    this.look = { distances: false, triangles: false, parts: scene.parts.map(() => true) };
    this.measure = new Measure(this.stage, this.overlay, document.getElementById('viewer-length'), (at) =>
      this.pickAt(at)
    );
    this.measure.onChange = () => this.drawOverlay();
    this.bindControls();
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
    this.measure.draw(sides.map((side) => (point) => this.view.project(point, this.view.renderers[side])));
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
    bindButton('viewer-reset', set(() => this.view.reset()));
    addParts(scene.parts, (parts) => {
      look.parts = parts;
      this.update();
    });
    this.bindDistances();
    this.bindLevels();
  }

  bindDistances() {
    const box = bind('viewer-distances', (element) => {
      this.look.distances = element.checked;
      this.update();
    });
    show('viewer-distances-line', this.scene.distances !== null);
    if (this.scene.distances) {
      addLegend(this.scene.distances);
      this.look.distances = box.checked;
    }
  }

  bindLevels() {
    const slider = bind('viewer-level', async (element) => {
      const level = Number(element.value);
      await this.load(level);
      this.level = level;
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
