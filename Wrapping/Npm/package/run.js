// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Each call runs in a worker of its own: its memory is free again when the call ends, and a canceled call ends at once.

/** Why a call was rejected or failed, as one sentence. */
export class BoneDecimateError extends Error {
  name = 'BoneDecimateError';
}

const LABEL_ARRAYS = [Int8Array, Uint8Array, Int16Array, Uint16Array, Int32Array, Uint32Array];

function check(isGood, sentence) {
  if (!isGood) {
    throw new BoneDecimateError(sentence);
  }
}

function isOf(array, kinds) {
  return kinds.some((Kind) => array instanceof Kind);
}

/** What the worker needs of a surface; arrays of anything else stay where they are. */
function surfaceFrom(surface, name) {
  const { points, triangles, tolerances, edgeLengths } = surface ?? {};
  check(isOf(points, [Float32Array, Float64Array]), `${name}.points is a Float32Array or a Float64Array`);
  check(isOf(triangles, [Int32Array, Uint32Array]), `${name}.triangles is an Int32Array or a Uint32Array`);
  check(points.length % 3 === 0, `${name}.points has three numbers for each point`);
  check(triangles.length % 3 === 0, `${name}.triangles has three indices for each triangle`);
  for (const [key, numbers] of Object.entries({ tolerances, edgeLengths })) {
    check(
      !numbers || (isOf(numbers, [Float32Array, Float64Array]) && 3 * numbers.length === points.length),
      `${name}.${key} has a number for each point`
    );
  }
  const taken = { points, triangles, tolerances, edgeLengths, isSingle: points instanceof Float32Array };
  if (surface.grid) {
    const { boundaryLabels, gridPoints, labelValues } = surface;
    const hasPoints = gridPoints?.length === points.length;
    const hasLabels = 3 * boundaryLabels?.length === 2 * triangles.length && labelValues?.length > 0;
    check(hasPoints && hasLabels, `${name} has a grid, so it has gridPoints, boundaryLabels and labelValues`);
    Object.assign(taken, { boundaryLabels, gridPoints, labelValues, grid: gridFrom(surface.grid, name) });
  }
  return taken;
}

function gridFrom({ dimensions, origin = [0, 0, 0], spacing = [1, 1, 1], direction }, name) {
  const axes = direction ?? [1, 0, 0, 0, 1, 0, 0, 0, 1];
  check(
    [dimensions, origin, spacing].every((each) => each?.length === 3) && axes.length === 9,
    `${name}.grid has dimensions, origin and spacing of three numbers and a direction of nine`
  );
  return { dimensions, origin, spacing, direction: axes };
}

function mapFrom({ labels, grid } = {}) {
  check(isOf(labels, LABEL_ARRAYS), 'map.labels is a typed array of integers of up to 32 bits');
  const taken = gridFrom(grid ?? {}, 'map');
  const voxels = taken.dimensions.reduce((product, size) => product * size, 1);
  check(voxels === labels.length, `map.labels has ${labels.length} labels for ${voxels} voxels`);
  return { labels, grid: taken };
}

function aborted(signal) {
  return signal.reason ?? new DOMException('The operation was aborted.', 'AbortError');
}

/**
 * The functions of the package.
 * @param createWorker Makes a worker: post(message), listen(onMessage, onError), end().
 * @param compile Gives the compiled WebAssembly.Module, once for all workers.
 */
export function makeFunctions(createWorker, compile) {
  let compiled = null;

  async function call(name, parameters, { onProgress, signal } = {}) {
    signal?.throwIfAborted();
    compiled ??= compile();
    const module = await compiled;
    signal?.throwIfAborted();
    const worker = await createWorker();
    let stop = null;
    try {
      return await new Promise((resolve, reject) => {
        stop = () => reject(aborted(signal));
        signal?.addEventListener('abort', stop);
        const onMessage = ({ progress, problem, result }) => {
          if (progress !== undefined) {
            onProgress?.(progress);
          } else if (problem !== undefined) {
            reject(new BoneDecimateError(problem));
          } else {
            resolve(result);
          }
        };
        worker.listen(onMessage, (error) => reject(new BoneDecimateError(`the worker failed: ${error.message}`)));
        worker.post({ module, name, parameters });
      });
    } finally {
      signal?.removeEventListener('abort', stop);
      worker.end();
    }
  }

  return {
    async decimate(surface, options = {}, run = {}) {
      const input = surfaceFrom(surface, 'surface');
      check(!input.edgeLengths || options.edgeLength > 0, 'surface.edgeLengths need edgeLength, an upper limit for all');
      const result = await call('decimate', [input, options], run);
      return { ...result, report: JSON.parse(result.report) };
    },
    async extract(map, options = {}, run = {}) {
      const { labels = [], background = 0, closed = true, ...others } = options;
      const [unknown] = Object.keys(others);
      check(!unknown, `there is no option ${unknown}`);
      return call('extract', [mapFrom(map), { labels, background, closed }], run);
    },
    async certify(reference, result, options = {}, run = {}) {
      const { tolerance, relativeGap = 1e-3, pointDistances = false, means = false, surfaces = false, ...others } = options;
      const [unknown] = Object.keys(others);
      check(!unknown, `there is no option ${unknown}`);
      check(tolerance === undefined || tolerance >= 0, 'tolerance is not negative, in mm');
      check(relativeGap >= 0 && relativeGap <= 1, 'relativeGap is from 0 to 1');
      const pair = [surfaceFrom(reference, 'reference'), surfaceFrom(result, 'result')];
      const found = await call('certify', [...pair, { tolerance, relativeGap, pointDistances, means, surfaces }], run);
      return { ...found, report: JSON.parse(found.report) };
    },
    optionTable: () => call('options', []),
    version: () => call('version', []),
  };
}
