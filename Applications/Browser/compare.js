// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Two files: the certificate of the second one against the first, without a reduction.
import { core } from './core.js';
import { above, below, count, during, fillTable, find, isBusy, listen, saveFile, say, show } from './page.js';

const DIRECTIONS = [
  ['reference_to_result', 'Reference to result'],
  ['result_to_reference', 'Result to reference'],
  ['boundary_reference_to_result', 'Open boundaries, reference to result'],
  ['boundary_result_to_reference', 'Open boundaries, result to reference'],
];
const ONE_SIDED = { reference_only: 'only the reference has some', result_only: 'only the result has some' };
const state = { pair: null, certificate: null };

/** @param pair Reference and result, each as setInput() of simplify.js takes it; null: nothing was read. */
export function setPair(pair) {
  Object.assign(state, { pair, certificate: null });
  find('certify').disabled = pair === null;
  find('swap').disabled = pair === null;
  const kindOf = ({ labels }) => (labels ? `, surfaces of ${labels} labels` : '');
  const lineOf = (input) => `${input.name}: ${count(input.surface)} triangles${kindOf(input)}`;
  ['reference', 'result'].forEach((id, side) => say(id, pair ? lineOf(pair[side]) : ''));
}

/** mm, or undefined if the field is empty. */
function tolerance() {
  const text = find('tolerance').value.trim();
  const value = Number(text);
  if (text !== '' && !(value >= 0 && value <= 1e30)) {
    throw new Error('the tolerance is a number of millimeters from 0 to 1e30');
  }
  return text === '' ? undefined : value;
}

/** Positions within triangles at which the certificate has found its lower bounds. */
function peaksOf(report, surfaces) {
  return DIRECTIONS.slice(0, 2).map(([key], side) => {
    const { lower, x, y, z, triangle } = report[key];
    return { distance: lower, position: [x, y, z], triangle, surface: surfaces[side] };
  });
}

/** Proves the distance of the pair and shows it. Within during(). */
export async function prove(signal) {
  const limit = tolerance();
  const onProgress = listen('Proving the distance of both surfaces');
  const surfaces = state.pair.map(({ surface }) => surface);
  const options = { tolerance: limit, pointDistances: true, means: true, surfaces: true };
  const found = await core.certify(...surfaces, options, { onProgress, signal });
  const [reference, result] = state.pair.map(({ name }) => name);
  state.certificate = { ...found.report, tolerance: limit, files: { reference, result, unit: 'mm' } };
  tell(state.certificate, found);
  await show({
    surfaces,
    names: ['Reference', 'Result'],
    distances: [found.referenceDistance, found.resultDistance],
    peaks: peaksOf(found.report, surfaces),
    isOfPatient: state.pair.some(({ isOfPatient }) => isOfPatient),
  });
}

const intervalText = ({ lower, upper }) => `${below(lower)} to ${above(upper)}`;

/** What exceeds the tolerance: the direction with the largest lower bound, or boundaries that one surface alone has. */
function violationText(report) {
  const found = DIRECTIONS.filter(([key]) => report[key]?.status === 'violated' && report[key].lower !== null);
  if (found.length === 0) {
    return `of open boundaries, ${ONE_SIDED[report.boundaries]}`;
  }
  const [key, words] = found.reduce((a, b) => (report[b[0]].lower > report[a[0]].lower ? b : a));
  const { lower, x, y, z } = report[key];
  const where = [x, y, z].map((value) => value.toFixed(2)).join(', ');
  return `${words.toLowerCase()}, the point ${where} is at least ${below(lower)} away`;
}

/** The status of the tolerance as a sentence. */
function statusText(report) {
  const limit = `${report.tolerance} mm`;
  if (report.status === 'proved') {
    return `Proved: no point of either surface is farther than ${limit} from the other one.`;
  }
  if (report.status === 'violated') {
    return `Violated: the tolerance is ${limit}; ${violationText(report)}.`;
  }
  return report.status === 'undecided'
    ? `Undecided: the tolerance of ${limit} lies between the bounds, which cannot be brought closer together.`
    : 'There is no tolerance to compare the distance with.';
}

function directionText(direction) {
  const { mean, mean_error: error, rms } = direction;
  const means = mean === undefined ? '' : `; mean ${mean.toPrecision(3)} \u00b1 ${error.toPrecision(1)} mm, RMS ${rms.toPrecision(3)} mm`;
  return intervalText(direction) + means;
}

/** None of a surface whose triangles cannot be used. */
function componentRows({ reference, result }) {
  return reference && result ? [['Components', `${reference.components} of the reference, ${result.components} of the result`]] : [];
}

function tell(report, found) {
  find('results').hidden = false;
  const [reference, result] = state.pair;
  say('first-count', count(reference.surface));
  say('second-count', count(result.surface));
  say('first-name', 'triangles of the reference');
  say('second-name', 'triangles of the result');
  say('upper', above(report.upper));
  const oneSided = ONE_SIDED[report.boundaries];
  fillTable('certificate', [
    ['Tolerance', statusText(report)],
    ['Largest distance, both directions', intervalText(report)],
    ...DIRECTIONS.filter(([key]) => report[key] && !(oneSided && key.startsWith('boundary_'))).map(([key, words]) => [
      words,
      directionText(report[key]),
    ]),
    ...(oneSided ? [['Open boundaries', oneSided]] : []),
    ...componentRows(report),
    ...found.warnings.map((sentence) => ['Warning', sentence]),
    ['Seconds', report.seconds.toFixed(2)],
  ]);
  document.documentElement.dataset.seconds = report.seconds.toFixed(3);
}

function swap() {
  setPair([state.pair[1], state.pair[0]]);
  during(prove);
}

function save() {
  const name = state.certificate.files.result.replace(/\.[^.]*$/, '');
  saveFile(`${name}-certificate.json`, `${JSON.stringify(state.certificate, null, 2)}\n`);
}

export function bindCompare() {
  const start = () => state.pair && !isBusy() && during(prove);
  find('certify').addEventListener('click', start);
  find('pair').addEventListener('submit', start); // the key Enter in the field
  find('swap').addEventListener('click', swap);
  find('save-json').addEventListener('click', save);
}
