// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The page: a file is dropped, decimated in a worker, shown and saved. Nothing is sent anywhere.
import { wrapWorker } from 'bonedecimate/browser-worker.js';
import { makeFunctions } from 'bonedecimate/run.js';
import wasm from 'bonedecimate/core.wasm';
import workerText from 'worker-text';

import { Viewer, canDraw, nextFrame } from '../viewer/viewer.js';
import { ACCEPTED, bytesOf, readFile } from './files.js';
import { fillForm, optionsOf } from './form.js';
import { makeScene } from './scene.js';

const GAP = 0.05; // of the bounds of a certificate that the run has not made
/** Files hold single precision, so that is what is proved. */
const DEFAULTS = { precision: 'Single' };
const find = (id) => document.getElementById(id);
const workerAddress = URL.createObjectURL(new Blob([workerText], { type: 'text/javascript' }));
const core = makeFunctions(
  () => wrapWorker(new Worker(workerAddress)),
  () => WebAssembly.compile(wasm)
);
const state = { name: '', input: null, result: null, viewer: null, canceler: null };

const count = (surface) => (surface.triangles.length / 3).toLocaleString('en-US');
/** Four digits, rounded so that a bound stays one. */
function millimeters(value, round) {
  const step = 10 ** (Math.floor(Math.log10(Math.max(value, 1e-9))) - 3);
  return `${Number((round(value / step) * step).toPrecision(4))} mm`;
}
const above = (value) => millimeters(value, Math.ceil);
const below = (value) => millimeters(value, Math.floor);

function say(id, text) {
  find(id).textContent = text;
  find(id).hidden = text === '';
}

/** Shows progress and the button that cancels, for as long as the work takes. */
async function during(work) {
  state.canceler = new AbortController();
  document.documentElement.dataset.state = 'busy';
  say('problem', '');
  try {
    await work(state.canceler.signal);
    document.documentElement.dataset.state = 'done';
  } catch (error) {
    const isCanceled = error.name === 'AbortError';
    say('problem', isCanceled ? 'Canceled. Nothing was changed.' : `${error.message}.`);
    document.documentElement.dataset.state = isCanceled ? 'canceled' : 'failed';
  } finally {
    state.canceler = null;
    find('bar').value = 0;
  }
}

function listen(step) {
  say('step', step);
  return (fraction) => {
    find('bar').value = fraction;
  };
}

/** In single precision, as the program has them. */
async function surfacesOf(map, run) {
  const surfaces = await core.extract(map, {}, run);
  return { ...surfaces, points: new Float32Array(surfaces.points) };
}

async function open(file) {
  await during(async (signal) => {
    find('results').hidden = true;
    find('run').disabled = true;
    Object.assign(state, { name: file.name, input: null, result: null });
    say('file', file.name);
    const onProgress = listen('Reading the file');
    await nextFrame();
    const { surface, map } = await readFile(file);
    listen('Extracting the surfaces of all labels');
    state.input = surface ?? (await surfacesOf(map, { onProgress, signal }));
    const labels = map ? `, ${state.input.labelValues.length - 1} labels` : '';
    say('file', `${file.name}: ${count(state.input)} triangles${labels}`);
    find('run').disabled = false;
  });
}

/** Distances of points come from the run, if it proves an error, and otherwise with the certificate after it. */
function optionsOfRun() {
  const options = optionsOf(find('options'));
  const hasBound = options.maxError > 0 || options.preset !== undefined;
  const measure = hasBound ? { measureInputDistances: 'on' } : { measure: 'off' };
  return { ...DEFAULTS, ...measure, ...options };
}

/** The certificate of the run, or one of its own where the run has no largest error; and a distance for each point, mm. */
async function proofOf(result, signal) {
  if (result.report.proof) {
    return { ...result.report.proof, isOfRun: true, distances: [result.inputDistance, result.distance] };
  }
  const onProgress = listen('Proving the distance of both surfaces');
  const options = { relativeGap: GAP, pointDistances: true };
  const found = await core.certify(state.input, result, options, { onProgress, signal });
  return { ...found.report, isOfRun: false, distances: [found.referenceDistance, found.resultDistance] };
}

async function run() {
  await during(async (signal) => {
    find('results').hidden = true;
    const start = performance.now();
    const onProgress = listen('Decimating');
    const result = await core.decimate(state.input, optionsOfRun(), { onProgress, signal });
    const seconds = (performance.now() - start) / 1000;
    const proof = await proofOf(result, signal);
    state.result = result;
    tell(result, proof, seconds);
    await show(result, proof.distances);
  });
}

function boundaryOf(proof) {
  const bounds = Object.entries(proof).filter(([name]) => name.startsWith('boundary_'));
  return Math.max(...bounds.map(([, { upper }]) => upper));
}

function row(name, value) {
  const line = document.createElement('tr');
  line.append(...[name, value].map((text) => Object.assign(document.createElement('td'), { textContent: text })));
  return line;
}

function tell(result, proof, seconds) {
  find('results').hidden = false;
  find('before').textContent = count(state.input);
  find('after').textContent = count(result);
  find('upper').textContent = above(proof.upper);
  const { input, output } = result.report;
  const rows = [
    ['Certificate', `no point of either surface is farther than ${above(proof.upper)} from the other one`],
    ['Largest distance, at least', below(proof.lower)],
    ...(proof.boundaries === 'both' ? [['Open boundaries', `within ${above(boundaryOf(proof))} of each other`]] : []),
    ['Proved', proof.isOfRun ? 'with every edit and once more at the end' : 'after the run'],
    ['Components', `${output.components} of ${input.components}`],
    ['Why it ended', result.stop],
    ['Seconds of decimation', seconds.toFixed(2)],
    ...result.warnings.map((warning) => ['Note', warning]),
    ...(result.contradiction ? [['Contradiction', result.contradiction]] : []),
  ];
  find('certificate').replaceChildren(...rows.map(([name, value]) => row(name, value)));
  document.documentElement.dataset.seconds = seconds.toFixed(3);
}

/** A new view in place of the last one. */
async function show(result, distances) {
  say('step', 'Drawing');
  state.viewer?.end();
  find('view').replaceChildren(find('viewer-template').content.cloneNode(true));
  if (!canDraw()) {
    say('problem', 'This browser has no WebGL 2, so there is no view of the surfaces.');
    return;
  }
  document.documentElement.classList.add('interactive');
  const { scene, pieces } = makeScene(state.input, result, distances);
  find('viewer-distances').checked = true;
  state.viewer = new Viewer(scene, async (index) => pieces[index]);
  await state.viewer.load(1);
  await state.viewer.load(0);
  state.viewer.update();
}

function save(format) {
  const name = state.name.replace(/\.(stl|ply|nii|nii\.gz)$/i, '');
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytesOf(state.result, format)]));
  link.download = `${name}-decimated.${format}`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

function bindDrop() {
  const drop = find('drop');
  const stop = (event) => event.preventDefault();
  document.addEventListener('dragover', stop);
  document.addEventListener('drop', (event) => {
    stop(event);
    const [file] = event.dataTransfer.files;
    if (file && !state.canceler) {
      open(file);
    }
  });
  drop.addEventListener('dragenter', () => drop.classList.add('over'));
  ['dragleave', 'drop'].forEach((name) => drop.addEventListener(name, () => drop.classList.remove('over')));
  find('choose').accept = ACCEPTED;
  find('choose').addEventListener('change', (event) => open(event.target.files[0]));
}

async function start() {
  bindDrop();
  find('run').addEventListener('click', run);
  find('cancel').addEventListener('click', () => state.canceler?.abort());
  find('save-stl').addEventListener('click', () => save('stl'));
  find('save-ply').addEventListener('click', () => save('ply'));
  fillForm(await core.optionTable(), find('main-options'), find('more-options'));
  find('option-maxError').value = '0.2';
  document.documentElement.dataset.viewer = 'ready';
}

start().catch((error) => {
  say('problem', `This browser cannot run the page: ${error.message}.`);
  document.documentElement.dataset.viewer = 'failed';
});
