// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The canvas: two renderers, one for each surface, with one camera and the same lights.
import '@kitware/vtk.js/Rendering/OpenGL/Actor';
import '@kitware/vtk.js/Rendering/OpenGL/Camera';
import '@kitware/vtk.js/Rendering/OpenGL/PolyDataMapper';
import '@kitware/vtk.js/Rendering/OpenGL/Renderer';
import { EVENT_ABORT } from '@kitware/vtk.js/macros';
import vtkInteractorStyleTrackballCamera from '@kitware/vtk.js/Interaction/Style/InteractorStyleTrackballCamera';
import vtkLight from '@kitware/vtk.js/Rendering/Core/Light';
import vtkOpenGLRenderWindow from '@kitware/vtk.js/Rendering/OpenGL/RenderWindow';
import vtkRenderer from '@kitware/vtk.js/Rendering/Core/Renderer';
import vtkRenderWindow from '@kitware/vtk.js/Rendering/Core/RenderWindow';
import vtkRenderWindowInteractor from '@kitware/vtk.js/Rendering/Core/RenderWindowInteractor';

const BACKGROUND = [0.965, 0.97, 0.975];
const WHOLE = [0, 0, 1, 1];
const LEFT = [0, 0, 0.5, 1];
const RIGHT = [0.5, 0, 1, 1];
const LEGEND = 84; // pixels below the surfaces, for the legend

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function makeLight(intensity) {
  return vtkLight.newInstance({ intensity, focalPoint: [0, 0, 0], lightType: 'CameraLight' });
}

/** Makes the context of the canvas. @returns Whether it is drawn by the processor, where smooth edges take most of the time. */
function makeContext(canvas) {
  const isSoftware = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(rendererName());
  canvas.getContext('webgl2', { antialias: !isSoftware, depth: true, alpha: true, powerPreference: 'high-performance' });
  return isSoftware;
}

/** What the browser says of its graphics hardware; some say nothing. */
function rendererName() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const name = gl.getParameter(gl.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER);
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return String(name);
}

export class View {
  constructor(stage, scene) {
    this.stage = stage;
    this.frame = scene.view;
    this.renderWindow = vtkRenderWindow.newInstance();
    this.canvas = vtkOpenGLRenderWindow.newInstance();
    this.canvas.setContainer(stage);
    this.isSoftware = makeContext(this.canvas.getCanvas());
    this.renderWindow.addView(this.canvas);
    this.renderers = { before: vtkRenderer.newInstance(), after: vtkRenderer.newInstance() };
    this.camera = this.renderers.before.getActiveCamera();
    this.lights = [makeLight(0.85), makeLight(0.3)];
    for (const renderer of Object.values(this.renderers)) {
      renderer.setBackground(...BACKGROUND);
      renderer.setActiveCamera(this.camera);
      renderer.setAutomaticLightCreation(false);
      this.lights.forEach((light) => renderer.addLight(light));
      this.renderWindow.addRenderer(renderer);
    }
    this.turnLight(-35);
    this.pixelRatio = this.isSoftware ? 1 : window.devicePixelRatio || 1;
    this.makeInteractor(stage);
    this.fitCanvas();
    this.compare('sides');
    this.reset();
  }

  /** Calls onResize after the canvas has the new size of the stage. */
  watchSize(onResize) {
    this.observer = new ResizeObserver(() => {
      const isHidden = this.stage.clientWidth === 0;
      if (!isHidden && this.fitCanvas()) {
        this.keepZoom(this.fitted);
        onResize();
      }
    });
    this.observer.observe(this.stage);
  }

  end() {
    this.observer?.disconnect();
    const gl = this.canvas.getContext();
    this.interactor.delete();
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }

  makeInteractor(stage) {
    this.interactor = vtkRenderWindowInteractor.newInstance();
    this.interactor.setView(this.canvas);
    this.interactor.initialize();
    this.interactor.setContainer(stage);
    this.interactor.onKeyPress(() => EVENT_ABORT, 1); // vtk.js has keys that change the surfaces
    this.interactor.setInteractorStyle(
      vtkInteractorStyleTrackballCamera.newInstance({ autoAdjustCameraClippingRange: false })
    );
  }

  /** From the side that the picture shows; the range of depth leaves space to pan. */
  reset() {
    const { center, toViewer, up, radius } = this.frame;
    this.camera.setParallelProjection(true);
    this.camera.setFocalPoint(...center);
    this.camera.setPosition(...center.map((value, axis) => value + 6 * radius * toViewer[axis]));
    this.camera.setViewUp(...up);
    this.camera.setClippingRange(0.1 * radius, 12 * radius);
    this.camera.setParallelScale(this.fittingScale());
  }

  /**
   * Shows a point closely.
   * @param position mm. @param toViewer Unit vector. @param free mm: what is nearer to the viewer than that is not drawn.
   */
  focus(position, toViewer, free) {
    const { radius } = this.frame;
    this.camera.setFocalPoint(...position);
    this.camera.setPosition(...position.map((value, axis) => value + 6 * radius * toViewer[axis]));
    this.camera.setViewUp(...(Math.abs(dot(toViewer, this.frame.up)) < 0.9 ? this.frame.up : this.frame.toViewer));
    this.camera.setClippingRange(6 * radius - free, 12 * radius);
    this.camera.setParallelScale(0.12 * radius);
  }

  /** Side by side, both in one view on either side of a divider, or one of them. */
  compare(mode) {
    const isBeside = mode === 'sides';
    const fitted = this.mode ? this.fittingScale() : 0;
    this.mode = mode;
    this.renderers.before.setViewport(...(isBeside ? LEFT : WHOLE));
    this.renderers.after.setViewport(...(isBeside ? RIGHT : WHOLE));
    // In one view the surface after is drawn over what is there.
    this.renderers.after.setPreserveColorBuffer(!isBeside);
    this.keepZoom(fitted);
  }

  /** After a change of the views. @param fitted Scale that showed everything before; 0: there was none. */
  keepZoom(fitted) {
    const zoom = fitted > 0 ? this.camera.getParallelScale() / fitted : 1;
    this.fitted = this.fittingScale();
    this.camera.setParallelScale(zoom * this.fitted);
    this.camera.setWindowCenter(0, -LEGEND / this.height());
  }

  /** Half of the height that a view shows of the space, mm, if it shows everything. */
  fittingScale() {
    const aboveLegend = Math.max(0.5, 1 - LEGEND / this.height());
    return Math.max(this.frame.halfHeight / aboveLegend, this.frame.halfWidth / this.aspect());
  }

  /** Pixels. */
  height() {
    return Math.max(1, this.stage.clientHeight);
  }

  /** Width of a view by its height. */
  aspect() {
    const width = this.mode === 'sides' ? 0.5 : 1;
    return (width * this.stage.clientWidth) / this.height();
  }

  /** @param angle Degrees of the main light from the viewer, positive to the right. */
  turnLight(angle) {
    const radians = (angle * Math.PI) / 180;
    this.lights[0].setPosition(Math.sin(radians), 0.75, Math.cos(radians));
    this.lights[1].setPosition(-0.4 * Math.sin(radians), -0.2, 1);
  }

  /** @returns Whether the canvas had another size. */
  fitCanvas() {
    const { clientWidth, clientHeight } = this.stage;
    const size = [clientWidth, clientHeight].map((length) => Math.max(1, Math.round(length * this.pixelRatio)));
    return this.canvas.setSize(...size);
  }

  render() {
    if (!this.isAnimating()) {
      this.renderWindow.render();
    }
  }

  isAnimating() {
    return this.interactor ? this.interactor.isAnimating() : true;
  }

  /** Waits until the last frame is on the canvas. */
  finish() {
    const gl = this.canvas.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** The position (CSS pixels in the stage) of a point of space in the view of a renderer. */
  project(point, renderer) {
    const [x, y] = this.canvas.worldToDisplay(...point, renderer);
    return [x / this.pixelRatio, this.stage.clientHeight - y / this.pixelRatio];
  }

  /** The ends of the line through a position of the stage (CSS pixels), from near to far. */
  lineAt([x, y], renderer) {
    const display = [x * this.pixelRatio, (this.stage.clientHeight - y) * this.pixelRatio];
    return [0, 1].map((depth) => this.canvas.displayToWorld(...display, depth, renderer));
  }

  /** Unit vectors of the view in space. */
  axes() {
    const forward = this.camera.getDirectionOfProjection();
    const up = this.camera.getViewUp();
    const right = cross(forward, up);
    const length = Math.hypot(...right);
    const unit = right.map((value) => value / length);
    return { forward, right: unit, up: cross(unit, forward) };
  }
}
