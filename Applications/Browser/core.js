// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// The functions of the package bonedecimate, from the text of the page itself.
import { wrapWorker } from 'bonedecimate/browser-worker.js';
import { makeFunctions } from 'bonedecimate/run.js';
import wasm from 'bonedecimate/core.wasm';
import workerText from 'worker-text';

const workerAddress = URL.createObjectURL(new Blob([workerText], { type: 'text/javascript' }));

export const core = makeFunctions(
  () => wrapWorker(new Worker(workerAddress)),
  () => WebAssembly.compile(wasm)
);
