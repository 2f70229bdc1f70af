// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// One file: its surface is decimated and saved.
import { core } from './core.js';
import { bytesOf } from './files.js';
import { optionsOf } from './form.js';
import { above, below, count, during, fillTable, find, listen, saveFile, say, show } from './page.js';

const GAP = 0.05; // of the bounds of a certificate that the run has not made
/** Files hold single precision, so that is what is proved. */
const DEFAULTS = { precision: 'Single' };
const state = { input: null, result: null };

/** @param input { name, surface, labels, isOfPatient }; null: nothing was read. */
export function setInput(input) {
  Object.assign(state, { input, result: null });
  find('run').disabled = input === null;
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
  const found = await core.certify(state.input.surface, result, options, { onProgress, signal });
  return { ...found.report, isOfRun: false, distances: [found.referenceDistance, found.resultDistance] };
}

async function run() {
  await during(async (signal) => {
    const start = performance.now();
    const onProgress = listen('Decimating');
    const { surface, isOfPatient } = state.input;
    const result = await core.decimate(surface, optionsOfRun(), { onProgress, signal });
    const seconds = (performance.now() - start) / 1000;
    const proof = await proofOf(result, signal);
    state.result = result;
    tell(result, proof, seconds);
    await show({ surfaces: [surface, result], names: ['Before', 'After'], distances: proof.distances, isOfPatient });
  });
}

function boundaryOf(proof) {
  const bounds = Object.entries(proof).filter(([name]) => name.startsWith('boundary_'));
  return Math.max(...bounds.map(([, { upper }]) => upper));
}

function tell(result, proof, seconds) {
  find('results').hidden = false;
  say('first-count', count(state.input.surface));
  say('second-count', count(result));
  say('first-name', 'triangles before');
  say('second-name', 'triangles after');
  say('upper', above(proof.upper));
  const { input, output, pruned } = result.report;
  fillTable('certificate', [
    ['Certificate', `no point of either surface is farther than ${above(proof.upper)} from the other one`],
    ['Largest distance, at least', below(proof.lower)],
    ...(proof.boundaries === 'both' ? [['Open boundaries', `within ${above(boundaryOf(proof))} of each other`]] : []),
    ['Proved', proof.isOfRun ? 'with every edit and once more at the end' : 'after the run'],
    ['Components', `${output.components} of ${input.components + (pruned?.components ?? 0)}`],
    ['Why it ended', result.stop],
    ['Seconds of decimation', seconds.toFixed(2)],
    ...result.warnings.map((warning) => ['Note', warning]),
    ...(result.contradiction ? [['Contradiction', result.contradiction]] : []),
  ]);
  document.documentElement.dataset.seconds = seconds.toFixed(3);
}

function save(format) {
  const name = state.input.name.replace(/\.(stl|ply|nii|nii\.gz)$/i, '');
  saveFile(`${name}-decimated.${format}`, bytesOf(state.result, format));
}

export function bindSimplify() {
  find('run').addEventListener('click', run);
  find('save-stl').addEventListener('click', () => save('stl'));
  find('save-ply').addEventListener('click', () => save('ply'));
}
