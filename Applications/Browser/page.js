// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The elements of the page: texts, tables, progress, the view and files to save.
import { Viewer, canDraw, nextFrame } from '../viewer/viewer.js';
import { makeScene } from './scene.js';

const KEPT = 60000; // ms, of a file that is being saved
let canceler = null;
let viewer = null;

export const find = (id) => document.getElementById(id);
export const count = (surface) => (surface.triangles.length / 3).toLocaleString('en-US');

/** Four digits, rounded so that a bound stays one. */
function millimeters(value, round) {
  if (!Number.isFinite(value)) {
    return 'not known';
  }
  const step = 10 ** (Math.floor(Math.log10(Math.max(value, 1e-9))) - 3);
  return `${Number((round(value / step) * step).toPrecision(4))} mm`;
}
export const above = (value) => millimeters(value, Math.ceil);
export const below = (value) => millimeters(value, Math.floor);

export function say(id, text) {
  find(id).textContent = text;
  find(id).hidden = text === '';
}

/** @param rows Texts of the cells. */
export function fillTable(id, rows) {
  const cell = (text) => Object.assign(document.createElement('td'), { textContent: text });
  const line = (texts) => {
    const row = document.createElement('tr');
    row.append(...texts.map(cell));
    return row;
  };
  find(id).replaceChildren(...rows.map(line));
}

/** Shows progress and the button that cancels, for as long as the work takes. */
export async function during(work) {
  canceler = new AbortController();
  document.documentElement.dataset.state = 'busy';
  say('problem', '');
  find('results').hidden = true;
  try {
    await work(canceler.signal);
    document.documentElement.dataset.state = 'done';
  } catch (error) {
    const isCanceled = error.name === 'AbortError';
    say('problem', isCanceled ? 'Canceled. Nothing was changed.' : `${error.message}.`);
    document.documentElement.dataset.state = isCanceled ? 'canceled' : 'failed';
  } finally {
    canceler = null;
    find('bar').value = 0;
  }
}

export const isBusy = () => canceler !== null;
export const cancel = () => canceler?.abort();

/** Names a step of the work. @returns Shows its progress. */
export function listen(step) {
  say('step', step);
  return (fraction) => {
    find('bar').value = fraction;
  };
}

/** A new view in place of the last one. @param subject As of makeScene(). */
export async function show(subject) {
  listen('Drawing');
  await nextFrame();
  viewer?.end();
  find('view').replaceChildren(find('viewer-template').content.cloneNode(true));
  if (!canDraw()) {
    say('problem', 'This browser has no WebGL 2, so there is no view of the surfaces.');
    return;
  }
  document.documentElement.classList.add('interactive');
  ['before', 'after'].forEach((side, i) => {
    const option = find('viewer-compare').querySelector(`[value=${side}]`);
    option.textContent = `${subject.names[i].toLowerCase()} alone`;
  });
  const { scene, pieces } = makeScene(subject);
  find('viewer-distances').checked = true;
  viewer = new Viewer(scene, async (index) => pieces[index]);
  await viewer.load(1);
  await viewer.load(0);
  viewer.update();
}

export function saveFile(name, bytes) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), KEPT);
}
