// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
import type { Options } from './options.js';

export type { Options } from './options.js';

/** Voxels of a label map. The direction has nine numbers, row by row; its columns are the axes. */
export interface VoxelGrid {
  dimensions: ArrayLike<number>;
  /** mm, the center of the first voxel; default 0, 0, 0. */
  origin?: ArrayLike<number>;
  /** mm; default 1, 1, 1. */
  spacing?: ArrayLike<number>;
  direction?: ArrayLike<number>;
}

/** What a surface knows of the label map it was extracted from. */
export interface LabelArrays {
  /** Of each triangle: the labels on its two sides, as indices into labelValues. */
  boundaryLabels: Int32Array;
  /** Of each point: where in the grid it was extracted. */
  gridPoints: Int32Array;
  /** The labels, ascending, and at the end the background. */
  labelValues: Float64Array;
  grid: VoxelGrid;
}

export interface Surface extends Partial<LabelArrays> {
  /** x, y and z of each point, mm. */
  points: Float32Array | Float64Array;
  /** Three indices of points for each triangle, counter-clockwise as seen from outside. */
  triangles: Int32Array | Uint32Array;
  /** mm, the largest error at each point: 0 keeps it, a negative number stands for `maxError`. */
  tolerances?: Float32Array | Float64Array;
  /** mm, above 0, the length that edges are to have at each point, at most `edgeLength`, which must be given. */
  edgeLengths?: Float32Array | Float64Array;
}

export interface LabelMap {
  /** x fastest, then y. */
  labels: Int8Array | Uint8Array | Int16Array | Uint16Array | Int32Array | Uint32Array;
  grid: VoxelGrid;
}

export interface Run {
  /** Called with the fraction done, from 0 to 1. */
  onProgress?: (fraction: number) => void;
  /** Ends the worker. The promise is rejected with the reason of the signal, an `AbortError` by default. */
  signal?: AbortSignal;
}

/** The report of the program, as Documentation/report.schema.json describes it. */
export type Report = Record<string, unknown>;

export interface DecimatedSurface {
  /** mm; a Float32Array if the run rounded them to single precision. */
  points: Float32Array | Float64Array;
  triangles: Int32Array;
  /** mm, of each point to the input; empty with `measure: false`. */
  distance: Float64Array;
  /** mm, proved around each point; empty without a proof. */
  errorBound: Float64Array;
  /** mm, of each input point to the result; empty without `measureInputDistances`. */
  inputDistance: Float64Array;
  /** mm, the same of what is proved. */
  inputErrorBound: Float64Array;
  /** How many input points each point represents. */
  pointCount: Int32Array;
  /** Of each point; empty without `maps`. */
  nearestTriangle: Int32Array;
  /** Of each input point: what it became part of, or -1; empty without `maps`. */
  outputPoint: Int32Array;
  /** Of each triangle, if the input had them. */
  boundaryLabels?: Int32Array;
  labelValues?: Float64Array;
  /** With the certificate in `report.proof`, if there is a largest error. */
  report: Report;
  /** Why the run ended. */
  stop: string;
  /** Defects of the input that were repaired or kept, a sentence each. */
  warnings: string[];
  /** A sentence if the certificate contradicts the run, which would be a defect of the program; else empty. */
  contradiction: string;
}

export interface ExtractOptions {
  /** Others count as background; default: all. */
  labels?: ArrayLike<number>;
  /** Default 0. */
  background?: number;
  /** Adds a voxel of background on all sides; default true. */
  closed?: boolean;
}

export interface CertifyOptions {
  /** mm; the report then says whether every point is within it. */
  tolerance?: number;
  /** The bounds differ by at most this fraction of the upper one, 0 to 1; default 1e-3. */
  relativeGap?: number;
  /** Also computes the distance of each point; default false. */
  pointDistances?: boolean;
  /** Also estimates average and root mean square in both directions, to half a percent; default false. */
  means?: boolean;
  /**
   * The report also has triangles, components, boundary edges, area, volume and intersecting pairs of both surfaces (`reference`, `result`),
   * and the components of the reference that the result lacks (`missing`). Warnings name these, too. Default false.
   */
  surfaces?: boolean;
}

export interface Certificate {
  /** mm, proved bounds of the two-sided distance of the surfaces. */
  lower: number;
  upper: number;
  /** As Documentation/certificate.schema.json describes it. */
  report: Report;
  /** What bounds do not tell, a sentence each: sizes that suggest another unit; with `surfaces` lost components and new defects. */
  warnings: string[];
  /** mm, of each point of the reference; empty without `pointDistances`. */
  referenceDistance: Float64Array;
  resultDistance: Float64Array;
}

export interface OptionRow {
  name: string;
  kind: 'number' | 'boolean' | 'choice' | 'string';
  unit: string;
  choices: string[];
  /** What it takes, as a sentence has it. */
  values: string;
  default: string;
  description: string;
}

/** Why a call was rejected or failed: its message is one sentence. */
export class BoneDecimateError extends Error {}

export function decimate(surface: Surface, options?: Options, run?: Run): Promise<DecimatedSurface>;

/** The surfaces of all labels: a wall between two labels is there once. */
export function extract(map: LabelMap, options?: ExtractOptions, run?: Run): Promise<Surface & LabelArrays>;

/** Proved bounds of the distance between any two surfaces. */
export function certify(reference: Surface, result: Surface, options?: CertifyOptions, run?: Run): Promise<Certificate>;

export function optionTable(): Promise<OptionRow[]>;
export function version(): Promise<string>;
