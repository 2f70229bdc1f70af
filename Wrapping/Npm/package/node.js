// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// For Node.js.
import { readFile } from 'node:fs/promises';
import { Worker } from 'node:worker_threads';
import { makeFunctions } from './run.js';

export { BoneDecimateError } from './run.js';

function createWorker() {
  const worker = new Worker(new URL('./node-worker.js', import.meta.url));
  return {
    post: (message) => worker.postMessage(message),
    listen(onMessage, onError) {
      worker.on('message', onMessage);
      worker.on('error', onError);
    },
    end: () => worker.terminate(),
  };
}

async function compile() {
  return WebAssembly.compile(await readFile(new URL('./core.wasm', import.meta.url)));
}

export const { decimate, extract, certify, optionTable, version } = makeFunctions(createWorker, compile);
