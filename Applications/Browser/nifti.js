// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Label maps from NIfTI files, with nifti-reader-js.
import * as nifti from 'nifti-reader-js';

const TYPES = {
  2: Uint8Array,
  4: Int16Array,
  8: Int32Array,
  16: Float32Array,
  64: Float64Array,
  256: Int8Array,
  512: Uint16Array,
  768: Uint32Array,
  1024: BigInt64Array,
  1280: BigUint64Array,
};
const MILLIMETERS = { 0: 1, 1: 1000, 2: 1, 3: 0.001 }; // of the unit of length; none means mm
const LARGEST_COSINE = 1e-3; // of two axes that count as perpendicular, as in the program

function check(isGood, sentence) {
  if (!isGood) {
    throw new Error(sentence);
  }
}

/** The other byte order, if the file has it. */
function inThisOrder(bytes, Type, isLittle) {
  const size = Type.BYTES_PER_ELEMENT;
  if (!isLittle && size > 1) {
    const view = new Uint8Array(bytes);
    for (let i = 0; i < view.length; i += size) {
      view.subarray(i, i + size).reverse();
    }
  }
  return new Type(bytes);
}

/** Whole numbers as 32 bits. */
function integersOf(values) {
  if (values instanceof BigInt64Array || values instanceof BigUint64Array) {
    const isSmall = values.every((value) => value >= -(2n ** 31n) && value < 2n ** 31n);
    check(isSmall, 'the file has labels of more than 32 bits: the program reads them');
    return Int32Array.from(values, Number);
  }
  if (!(values instanceof Float32Array || values instanceof Float64Array)) {
    return values;
  }
  const labels = Int32Array.from(values);
  check(
    labels.every((label, i) => label === values[i]),
    'the file has fractions: it is an image and not a label map'
  );
  return labels;
}

/** Codes and numbers of both positions, in the unit of the file. Version 2 has them at other bytes, with double precision. */
function formsOf(data, header) {
  const isFirst = header instanceof nifti.NIFTI1;
  const view = new DataView(data);
  const isLittle = header.littleEndian;
  const real = (first, count) =>
    Array.from({ length: count }, (_, i) =>
      isFirst ? view.getFloat32(first + 4 * i, isLittle) : view.getFloat64(first + 8 * i, isLittle)
    );
  const code = (first) => (isFirst ? view.getInt16(first, isLittle) : view.getInt32(first, isLittle));
  const at = isFirst ? { q: 252, s: 254, turn: 256, offset: 268, rows: 280 } : { q: 344, s: 348, turn: 352, offset: 376, rows: 400 };
  const rows = real(at.rows, 12);
  return {
    hasQform: code(at.q) > 0,
    sformCode: code(at.s),
    quaternion: real(at.turn, 3),
    offset: real(at.offset, 3),
    sform: [0, 1, 2, 3].map((i) => [rows[i], rows[4 + i], rows[8 + i]]),
  };
}

/** Of a qform: the axes and the position of the first voxel. */
function columnsOfQform({ quaternion: [b, c, d], offset }, pixDims) {
  const a = Math.sqrt(Math.max(0, 1 - b * b - c * c - d * d));
  const axes = [
    [a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)],
    [2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)],
    [2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b],
  ];
  const lengths = [pixDims[1], pixDims[2], pixDims[0] < 0 ? -pixDims[3] : pixDims[3]];
  return [...axes.map((axis, i) => axis.map((value) => value * lengths[i])), offset];
}

/**
 * The axes and the position of the first voxel, RAS, by the rule of the program: the sform if it is that of the scanner or the only one,
 * otherwise the qform; without both, x runs to the left and y to the back, as in ITK.
 */
function columnsOf(data, header) {
  const forms = formsOf(data, header);
  const { pixDims } = header;
  if (forms.sformCode === 1 || (forms.sformCode > 0 && !forms.hasQform)) {
    const isSame = [0, 1, 2].every((i) => Math.abs(Math.hypot(...forms.sform[i]) - pixDims[i + 1]) <= 1e-3 * pixDims[i + 1]);
    check(isSame, 'the spacing of the file is not that of its sform');
    return forms.sform;
  }
  return forms.hasQform ? columnsOfQform(forms, pixDims) : [[-pixDims[1], 0, 0], [0, -pixDims[2], 0], [0, 0, pixDims[3]], [0, 0, 0]];
}

const dot = (one, other) => one.reduce((sum, value, i) => sum + value * other[i], 0);
const cross = (one, other) => [0, 1, 2].map((i) => one[(i + 1) % 3] * other[(i + 2) % 3] - one[(i + 2) % 3] * other[(i + 1) % 3]);

/** The nearest perpendicular axes, by Higham's iteration, of those that are rounded; the program takes the same ones. */
function perpendicular(axes) {
  const isClose = [0, 1, 2].every((i) => Math.abs(dot(axes[i], axes[(i + 1) % 3])) <= LARGEST_COSINE);
  check(isClose, 'the axes of the file are not perpendicular, which those of a label map have to be');
  let turned = axes;
  for (let step = 0; step < 8; ++step) {
    const others = [0, 1, 2].map((i) => cross(turned[(i + 1) % 3], turned[(i + 2) % 3]));
    const volume = dot(turned[0], others[0]);
    turned = turned.map((axis, i) => axis.map((value, row) => 0.5 * (value + others[i][row] / volume)));
  }
  return turned;
}

/** NIfTI has x to the right and y to the front; this project, as ITK and DICOM, to the left and to the back. */
function gridOf(data, header, dimensions) {
  const unit = MILLIMETERS[header.xyzt_units & 7];
  check(unit, 'the unit of length of the file is not known: save it in millimeters');
  const [...columns] = columnsOf(data, header).map((column) => column.map((value, row) => (row < 2 ? -1 : 1) * unit * value));
  const spacing = columns.slice(0, 3).map((axis) => Math.hypot(...axis));
  check(spacing.every((length) => length > 0 && Number.isFinite(length)), 'the file has no valid voxel size');
  const axes = perpendicular(columns.slice(0, 3).map((axis, i) => axis.map((value) => value / spacing[i])));
  const direction = [0, 1, 2].flatMap((row) => axes.map((axis) => axis[row]));
  return { dimensions, origin: columns[3], spacing, direction };
}

/** Labels and grid. Throws an Error with one sentence. */
export function readLabelMap(buffer) {
  const data = nifti.isCompressed(buffer) ? nifti.decompress(buffer) : buffer;
  check(nifti.isNIFTI(data), 'the file is damaged: it has no NIfTI header');
  const header = nifti.readHeader(data);
  const dimensions = [1, 2, 3].map((i) => (i <= header.dims[0] ? header.dims[i] : 1));
  const others = header.dims.slice(4, 1 + header.dims[0]);
  check(others.every((size) => size <= 1), 'the file has more than one image');
  const isBehind = header.vox_offset >= (header instanceof nifti.NIFTI1 ? 348 : 540);
  check(isBehind, 'the voxels of the file begin inside its header by vox_offset: save it again as .nii');
  const Type = TYPES[header.datatypeCode];
  check(Type, 'the file has colors or complex numbers and not labels');
  const hasScale = header.scl_slope !== 0 && (header.scl_slope !== 1 || header.scl_inter !== 0);
  check(!hasScale || Number.isNaN(header.scl_slope), 'the file scales its values: it is an image and not a label map');
  const voxels = dimensions.reduce((product, size) => product * size, 1);
  const bytes = nifti.readImage(header, data).slice(0, voxels * Type.BYTES_PER_ELEMENT);
  check(bytes.byteLength === voxels * Type.BYTES_PER_ELEMENT, 'the file ends early: voxels are missing');
  const labels = integersOf(inThisOrder(bytes, Type, header.littleEndian));
  return { labels, grid: gridOf(data, header, dimensions) };
}
