// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// What a worker does: one call of the core.
import createCore from './core.js';

const LEAST_PAUSE = 40; // ms, between two messages of progress
const TAKES_PROGRESS = new Set(['decimate', 'extract', 'certify']);

function buffersOf(result) {
  const arrays = Object.values(result).filter((value) => ArrayBuffer.isView(value));
  return arrays.map((array) => array.buffer);
}

/** What ended a run: the core throws nothing but std::bad_alloc, which aborts the instance. */
function sentenceOf(error) {
  const text = String(error?.message ?? error);
  return /Aborted|allocation|memory/i.test(text)
    ? `the surface needs more memory than there is for WebAssembly, which has 4 GB at most (${text})`
    : `the core failed: ${text}`;
}

/** @param post Sends { progress }, { problem } or { result } to the caller. */
export async function runJob({ module, name, parameters }, post) {
  let last = 0;
  const onProgress = (progress) => {
    const now = performance.now();
    if (now - last >= LEAST_PAUSE) {
      last = now;
      post({ progress }, []);
    }
  };
  try {
    const core = await createCore({
      instantiateWasm(imports, receive) {
        WebAssembly.instantiate(module, imports).then((instance) => receive(instance, module));
        return {};
      },
      printErr() {},
    });
    const result = core[name](...parameters, ...(TAKES_PROGRESS.has(name) ? [onProgress] : []));
    if (result.problem !== undefined) {
      post({ problem: result.problem }, []);
    } else {
      post({ result }, buffersOf(result));
    }
  } catch (error) {
    post({ problem: sentenceOf(error) }, []);
  }
}
