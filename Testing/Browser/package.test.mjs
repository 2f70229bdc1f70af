// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The package for npm under Node.js: node --test package.test.mjs. PACKAGE is its folder, NATIVE the program bonedecimate, or empty.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

const { BoneDecimateError, certify, decimate, extract, optionTable } = await import(
  pathToFileURL(resolve(process.env.PACKAGE, 'node.js'))
);

/** A ball of so many rings, with dents. */
function ball(rings) {
  const points = [];
  const triangles = [];
  for (let i = 0; i < rings; ++i) {
    for (let j = 0; j < 2 * rings; ++j) {
      const [u, v] = [((i + 0.5) * Math.PI) / rings, (j * Math.PI) / rings];
      const r = 20 + Math.fround(Math.sin(7 * u) * Math.cos(5 * v));
      points.push(r * Math.sin(u) * Math.cos(v), r * Math.sin(u) * Math.sin(v), r * Math.cos(u));
      if (i > 0) {
        const [a, b] = [(i - 1) * 2 * rings + j, (i - 1) * 2 * rings + ((j + 1) % (2 * rings))];
        const [c, d] = [a + 2 * rings, b + 2 * rings];
        triangles.push(a, c, b, b, c, d);
      }
    }
  }
  return { points: new Float32Array(points), triangles: new Uint32Array(triangles) };
}

function cubeOfLabels() {
  const size = 12;
  const labels = new Uint8Array(size ** 3);
  for (let i = 0; i < labels.length; ++i) {
    const at = [i % size, Math.floor(i / size) % size, Math.floor(i / size ** 2)];
    const isInside = at.every((x) => x >= 3 && x < 9);
    labels[i] = isInside ? (at[0] < 6 ? 4 : 7) : 0;
  }
  return { labels, grid: { dimensions: [size, size, size], spacing: [0.5, 0.5, 0.75] } };
}

function plyOf({ points, triangles }) {
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${points.length / 3}\nproperty float x\nproperty float y\nproperty float z\n`;
  const faces = Buffer.alloc((triangles.length / 3) * 13);
  for (let t = 0; t < triangles.length / 3; ++t) {
    faces.writeUInt8(3, 13 * t);
    [0, 1, 2].forEach((i) => faces.writeInt32LE(triangles[3 * t + i], 13 * t + 1 + 4 * i));
  }
  const rest = `element face ${triangles.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`;
  return Buffer.concat([Buffer.from(header + rest), Buffer.from(points.buffer), faces]);
}

/** Points and triangles of a binary PLY file of the program. */
function fromPly(bytes) {
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.subarray(0, end).toString();
  const count = (name) => Number(header.match(new RegExp(`element ${name} (\\d+)`))[1]);
  const points = bytes.subarray(end, end + 12 * count('vertex'));
  const triangles = new Int32Array(3 * count('face'));
  for (let t = 0; t < count('face'); ++t) {
    const at = end + points.length + 13 * t;
    [0, 1, 2].forEach((i) => (triangles[3 * t + i] = bytes.readInt32LE(at + 1 + 4 * i)));
  }
  return { points: Buffer.from(points), triangles };
}

async function rejects(promise, pattern) {
  await assert.rejects(promise, (error) => error instanceof BoneDecimateError && pattern.test(error.message));
}

test('proves the largest error', async () => {
  const input = ball(40);
  const fractions = [];
  const result = await decimate(input, { maxError: 0.1 }, { onProgress: (done) => fractions.push(done) });
  assert.ok(result.points instanceof Float32Array);
  assert.ok(result.triangles.length < 0.5 * input.triangles.length);
  assert.ok(result.errorBound.length === result.points.length / 3 && Math.max(...result.errorBound) <= 0.1);
  assert.equal(result.contradiction, '');
  const found = await certify(input, result, { tolerance: 0.1 });
  assert.ok(found.upper <= 0.1 && found.lower <= found.upper);
  assert.ok(fractions.every((done, i) => i === 0 || done >= fractions[i - 1]));
});

/** Two squares at a height, without common points: each has two triangles with corners of their own. */
function squaresAt(height) {
  const square = (x) => [x, 0, x + 1, 0, x + 1, 1, x, 0, x + 1, 1, x, 1];
  const flat = [...square(0), ...square(3)];
  const points = Array.from({ length: flat.length / 2 }, (_, i) => [flat[2 * i], flat[2 * i + 1], height]).flat();
  return { points: new Float32Array(points), triangles: Uint32Array.from(points.slice(0, points.length / 3), (_, i) => i) };
}

test('certifies with means, distances of points, and figures of both surfaces', async () => {
  const [reference, result] = [squaresAt(0), squaresAt(0.75)];
  const found = await certify(reference, result, { tolerance: 0.7, means: true, pointDistances: true, surfaces: true });
  assert.ok(found.lower <= 0.75 && 0.75 <= found.upper && found.upper < 0.751);
  assert.equal(found.report.status, 'violated');
  for (const direction of ['reference_to_result', 'result_to_reference']) {
    assert.ok(Math.abs(found.report[direction].mean - 0.75) < 0.01 && Math.abs(found.report[direction].rms - 0.75) < 0.01);
  }
  assert.deepEqual([found.report.reference.components, found.report.result.components, found.report.missing], [2, 2, undefined]);
  assert.deepEqual(found.warnings, []);
  assert.ok(found.referenceDistance.length === 12 && found.referenceDistance.every((distance) => Math.abs(distance - 0.75) < 1e-6));
  const without = await certify(reference, reference);
  assert.deepEqual([without.upper < 1e-6, without.report.reference_to_result.mean, without.report.reference], [true, undefined, undefined]);
  const one = { points: result.points, triangles: result.triangles.slice(0, 6) };
  const lost = await certify(reference, one, { surfaces: true });
  assert.ok(lost.warnings.some((warning) => warning.startsWith('1 of 2 components of the reference is missing in the result')));
  assert.equal(lost.report.missing.length, 1);
});

test('gives the bytes of the program', { skip: !process.env.NATIVE }, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'bonedecimate-'));
  try {
    const input = ball(60);
    writeFileSync(join(folder, 'in.ply'), plyOf(input));
    for (const [options, words] of [
      [{ maxError: 0.1 }, ['--max-error', '0.1']],
      [{ targetTriangles: 900, mode: 'Accurate' }, ['--target-triangles', '900', '--mode', 'Accurate']],
    ]) {
      execFileSync(process.env.NATIVE, [join(folder, 'in.ply'), join(folder, 'out.ply'), ...words], { stdio: 'pipe' });
      const native = fromPly(readFileSync(join(folder, 'out.ply')));
      const result = await decimate(input, options);
      assert.deepEqual(result.triangles, native.triangles);
      assert.ok(native.points.equals(Buffer.from(result.points.buffer)));
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('extracts, smooths and decimates a label map', async () => {
  const surface = await extract(cubeOfLabels());
  assert.deepEqual([...surface.labelValues], [4, 7, 0]);
  const result = await decimate(surface, { smooth: 0.3, maxError: 0.4 });
  assert.ok(result.triangles.length < surface.triangles.length);
  assert.deepEqual([...new Set(result.boundaryLabels)].sort(), [0, 1, 2]);
  const one = await extract(cubeOfLabels(), { labels: [7] });
  assert.ok(one.triangles.length < surface.triangles.length);
});

test('ends at once when it is canceled', async () => {
  const canceler = new AbortController();
  const run = decimate(ball(300), { maxError: 0.01 }, { signal: canceler.signal, onProgress: () => canceler.abort() });
  await assert.rejects(run, { name: 'AbortError' });
  await assert.rejects(decimate(ball(10), {}, { signal: AbortSignal.abort() }), { name: 'AbortError' });
});

test('rejects what is wrong with one sentence', async () => {
  const input = ball(10);
  await rejects(decimate(input, { maxErr: 1 }), /there is no option maxErr/);
  await rejects(decimate(input, { maxError: -1 }), /from 0 to 1e30 mm/);
  await rejects(decimate(input, { maxError: 'far' }), /./);
  const { choices } = (await optionTable()).find(({ name }) => name === 'mode');
  await rejects(decimate(input, { mode: 'Best' }), new RegExp(choices.join(', ')));
  await rejects(decimate(input, { targetTriangles: 1.5 }), /whole number/);
  await rejects(decimate(input, { voxelSize: 1 }), /no effect/);
  await rejects(decimate({ points: [0, 0, 0], triangles: input.triangles }), /Float32Array/);
  await rejects(decimate({ points: input.points, triangles: new Uint32Array([0, 1, 4e9]) }), /./);
  await rejects(decimate({ points: new Float32Array(9).fill(NaN), triangles: new Uint32Array([0, 1, 2]) }), /./);
  await rejects(extract({ labels: new Uint8Array(5), grid: { dimensions: [2, 2, 2] } }), /5 labels for 8 voxels/);
  await rejects(certify(input, { ...input, triangles: new Uint32Array(0) }), /./);
});

test('has every option of the table by name', async () => {
  const rows = await optionTable();
  const types = readFileSync(resolve(process.env.PACKAGE, 'options.d.ts'), 'utf8');
  assert.ok(rows.length > 20);
  rows.forEach(({ name }) => assert.match(types, new RegExp(`^  ${name}\\?: `, 'm')));
});
