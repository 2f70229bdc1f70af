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
};
const MILLIMETERS = { 1: 1000, 2: 1, 3: 0.001 }; // of the unit of length; none means mm

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

/** NIfTI has x to the right and y to the front; this project, as ITK and DICOM, to the left and to the back. */
function gridOf(header, dimensions) {
  const unit = MILLIMETERS[header.xyzt_units & 7] ?? 1;
  const column = (i) => header.affine.slice(0, 3).map((row, axis) => (axis < 2 ? -1 : 1) * unit * row[i]);
  const columns = [0, 1, 2].map(column);
  const spacing = columns.map((axis) => Math.hypot(...axis));
  check(spacing.every((length) => length > 0 && Number.isFinite(length)), 'the file has no valid voxel size');
  const direction = [0, 1, 2].flatMap((row) => columns.map((axis, i) => axis[row] / spacing[i]));
  return { dimensions, origin: column(3), spacing, direction };
}

/** Labels and grid. Throws an Error with one sentence. */
export function readLabelMap(buffer) {
  const data = nifti.isCompressed(buffer) ? nifti.decompress(buffer) : buffer;
  check(nifti.isNIFTI(data), 'the file is damaged: it has no NIfTI header');
  const header = nifti.readHeader(data);
  const dimensions = [1, 2, 3].map((i) => (i <= header.dims[0] ? header.dims[i] : 1));
  const others = header.dims.slice(4, 1 + header.dims[0]);
  check(others.every((size) => size <= 1), 'the file has more than one image');
  const Type = TYPES[header.datatypeCode];
  check(Type, 'the file has colors or complex numbers and not labels');
  const hasScale = header.scl_slope !== 0 && (header.scl_slope !== 1 || header.scl_inter !== 0);
  check(!hasScale || Number.isNaN(header.scl_slope), 'the file scales its values: it is an image and not a label map');
  const voxels = dimensions.reduce((product, size) => product * size, 1);
  const bytes = nifti.readImage(header, data).slice(0, voxels * Type.BYTES_PER_ELEMENT);
  check(bytes.byteLength === voxels * Type.BYTES_PER_ELEMENT, 'the file ends early: voxels are missing');
  const labels = integersOf(inThisOrder(bytes, Type, header.littleEndian));
  return { labels, grid: gridOf(header, dimensions) };
}
