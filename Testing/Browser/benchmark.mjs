// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Seconds of the package and of meshoptimizer's simplifier, both as WebAssembly in Node.js, which has Chromium's engine, with the certificate of each:
//   benchmark.mjs BUILD MESH.ply TRIANGLES     BUILD: build/wasm; MESH: binary, single precision, as Testing/Benchmark makes it
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [build, mesh, wanted] = process.argv.slice(2);
const load = (...names) => import(pathToFileURL(resolve(build, ...names)));
const { certify, decimate } = await load('npm/node.js');
const modules = 'Applications/Browser/bundle/node_modules';
const { MeshoptSimplifier } = await load(modules, 'meshoptimizer/meshopt_simplifier.js');
await MeshoptSimplifier.ready;

function readPly(path) {
  const bytes = readFileSync(path);
  const end = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  const header = bytes.subarray(0, end).toString();
  const count = (name) => Number(header.match(new RegExp(`element ${name} (\\d+)`))[1]);
  const faces = end + 12 * count('vertex');
  const points = new Float32Array(bytes.buffer.slice(bytes.byteOffset + end, bytes.byteOffset + faces));
  const triangles = new Uint32Array(3 * count('face'));
  for (let i = 0; i < triangles.length; ++i) {
    triangles[i] = bytes.readUInt32LE(faces + 13 * Math.floor(i / 3) + 1 + 4 * (i % 3));
  }
  return { points, triangles };
}

const input = readPly(mesh);
const targetTriangles = Number(wanted);
const programs = {
  Fast: () => decimate(input, { targetTriangles, mode: 'Fast', measure: false }),
  Balanced: () => decimate(input, { targetTriangles, measure: false }),
  meshoptimizer: () => {
    const [triangles] = MeshoptSimplifier.simplify(input.triangles, input.points, 3, 3 * targetTriangles, 1);
    return { points: input.points, triangles };
  },
};
for (const [name, run] of Object.entries(programs)) {
  const seconds = [];
  let result = null;
  for (let round = 0; round < 3; ++round) {
    const start = performance.now();
    result = await run();
    seconds.push((performance.now() - start) / 1000);
  }
  const { lower, upper } = await certify(input, result, { relativeGap: 0.05 });
  const figures = [Math.min(...seconds), result.triangles.length / 3, lower, upper].map((value) => Number(value.toPrecision(4)));
  console.log(name, ...figures);
}
