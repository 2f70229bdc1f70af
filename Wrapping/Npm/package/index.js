// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// For browsers and bundlers.
import { wrapWorker } from './browser-worker.js';
import { makeFunctions } from './run.js';

export { BoneDecimateError } from './run.js';

function createWorker() {
  return wrapWorker(new Worker(new URL('./worker.js', import.meta.url), { type: 'module' }));
}

async function compile() {
  const response = await fetch(new URL('./core.wasm', import.meta.url));
  return WebAssembly.compile(await response.arrayBuffer());
}

export const { decimate, extract, certify, optionTable, version } = makeFunctions(createWorker, compile);
