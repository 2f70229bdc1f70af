// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The interactive view of the page. Without WebGL the page keeps its picture.
import { bytesOf, decodeSurface } from './decode.js';
import { Viewer, canDraw, nextFrame } from './viewer.js';

async function start() {
  const root = document.documentElement;
  if (!canDraw()) {
    root.dataset.viewer = 'unavailable';
    return;
  }
  root.classList.add('interactive');
  const scene = JSON.parse(document.getElementById('viewer-scene').textContent);
  const data = [...document.querySelectorAll('script.surface')];
  const viewer = new Viewer(scene, async (index) =>
    decodeSurface(await bytesOf(data[index]), scene.surfaces[index], scene.grid)
  );
  await viewer.load(viewer.level);
  viewer.update();
  viewer.view.finish();
  performance.mark('viewer-drawn'); // the result; the original, which is larger, follows
  await nextFrame();
  await viewer.load(0);
  viewer.update();
  root.dataset.viewer = 'ready';
}

start().catch((error) => {
  document.documentElement.classList.remove('interactive');
  document.documentElement.dataset.viewer = 'failed';
  console.error(error);
});
