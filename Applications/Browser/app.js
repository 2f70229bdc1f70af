// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The page: one file that is dropped is decimated (simplify.js), two are compared (compare.js), in a worker. Nothing is sent anywhere.
import { nextFrame } from '../viewer/viewer.js';
import { bindCompare, prove, setPair } from './compare.js';
import { core } from './core.js';
import { ACCEPTED, readFile } from './files.js';
import { fillForm } from './form.js';
import { cancel, count, during, find, isBusy, listen, say } from './page.js';
import { bindSimplify, setInput } from './simplify.js';

const MOST_FILES = 2;

/** In single precision, as the program has them. */
async function surfacesOf(map, run) {
  const surfaces = await core.extract(map, {}, run);
  return { ...surfaces, points: new Float32Array(surfaces.points) };
}

/** @returns { name, surface, labels, isOfPatient }; labels and the axes of patients are those of a label map. */
async function inputOf(file, signal) {
  const onProgress = listen(`Reading ${file.name}`);
  await nextFrame();
  try {
    const { surface, map } = await readFile(file);
    listen(`Extracting the surfaces of all labels of ${file.name}`);
    const found = surface ?? (await surfacesOf(map, { onProgress, signal }));
    return { name: file.name, surface: found, labels: map ? found.labelValues.length - 1 : 0, isOfPatient: Boolean(map) };
  } catch (error) {
    throw error.name === 'AbortError' ? error : new Error(`${file.name}: ${error.message}`);
  }
}

/** One file is ready to be decimated; two are compared at once, the first with the second. */
async function take(inputs, signal) {
  say('file', '');
  if (inputs.length > 1) {
    setPair(inputs);
    await prove(signal);
    return;
  }
  const [{ name, surface, labels }] = inputs;
  setInput(inputs[0]);
  say('file', `${name}: ${count(surface)} triangles${labels ? `, ${labels} labels` : ''}`);
}

async function open(files) {
  document.documentElement.dataset.files = files.length > 1 ? 'two' : 'one';
  say('file', files.map(({ name }) => name).join(', '));
  setInput(null);
  setPair(null);
  await during(async (signal) => {
    if (files.length > MOST_FILES) {
      throw new Error(`these are ${files.length} files: drop one to simplify it, or two to compare them`);
    }
    const inputs = [];
    for (const file of files) {
      inputs.push(await inputOf(file, signal));
    }
    await take(inputs, signal);
  });
}

function bindDrop() {
  const drop = find('drop');
  const stop = (event) => event.preventDefault();
  const openAll = (files) => {
    if (files.length > 0 && !isBusy()) {
      open([...files]);
    }
  };
  document.addEventListener('dragover', stop);
  document.addEventListener('drop', (event) => {
    stop(event);
    openAll(event.dataTransfer.files);
  });
  drop.addEventListener('dragenter', () => drop.classList.add('over'));
  ['dragleave', 'drop'].forEach((name) => drop.addEventListener(name, () => drop.classList.remove('over')));
  find('choose').accept = ACCEPTED;
  find('choose').addEventListener('change', ({ target }) => {
    openAll(target.files);
    target.value = ''; // the same file may be chosen again
  });
}

async function start() {
  bindDrop();
  bindSimplify();
  bindCompare();
  find('cancel').addEventListener('click', cancel);
  fillForm(await core.optionTable(), find('main-options'), find('more-options'));
  find('option-maxError').value = '0.2';
  document.documentElement.dataset.viewer = 'ready';
}

start().catch((error) => {
  say('problem', `This browser cannot run the page: ${error.message}.`);
  document.documentElement.dataset.viewer = 'failed';
});
