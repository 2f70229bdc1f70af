// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A worker of the browser as makeFunctions takes it. */
export function wrapWorker(worker) {
  return {
    post: (message) => worker.postMessage(message),
    listen(onMessage, onError) {
      worker.onmessage = ({ data }) => onMessage(data);
      worker.onerror = (event) => onError(event);
    },
    end: () => worker.terminate(),
  };
}
