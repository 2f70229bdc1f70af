// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Surfaces from and to files, with the readers and writers of vtk.js.
import vtkCellArray from '@kitware/vtk.js/Common/Core/CellArray';
import vtkPLYReader from '@kitware/vtk.js/IO/Geometry/PLYReader';
import { FormatTypes, TextureCoordinatesName } from '@kitware/vtk.js/IO/Geometry/PLYWriter/Constants';
import vtkPLYWriter from '@kitware/vtk.js/IO/Geometry/PLYWriter';
import vtkPoints from '@kitware/vtk.js/Common/Core/Points';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkSTLReader from '@kitware/vtk.js/IO/Geometry/STLReader';

import { readLabelMap } from './nifti.js';

const STL_HEADER = 84; // bytes
const STL_TRIANGLE = 50;

function check(isGood, sentence) {
  if (!isGood) {
    throw new Error(sentence);
  }
}

function textAt(buffer, length) {
  return new TextDecoder('latin1').decode(new Uint8Array(buffer, 0, Math.min(length, buffer.byteLength)));
}

/** Points and triangles; polygons become fans. */
function surfaceOf(polydata) {
  const cells = polydata.getPolys().getData();
  const triangles = [];
  for (let at = 0; at < cells.length; at += cells[at] + 1) {
    for (let i = 2; i < cells[at]; ++i) {
      triangles.push(cells[at + 1], cells[at + i], cells[at + i + 1]);
    }
  }
  const points = polydata.getPoints().getData();
  check(triangles.length > 0 && points.length > 0, 'the file has no triangles');
  return { points: new Float32Array(points), triangles: new Uint32Array(triangles) };
}

function readStl(buffer) {
  const reader = vtkSTLReader.newInstance();
  const count = buffer.byteLength >= STL_HEADER ? new DataView(buffer).getUint32(STL_HEADER - 4, true) : 0;
  if (buffer.byteLength === STL_HEADER + STL_TRIANGLE * count && count > 0) {
    reader.parseAsArrayBuffer(buffer);
  } else {
    const isText = /^\s*solid\s/.test(textAt(buffer, 100)) && /facet/.test(textAt(buffer, 2000));
    check(isText, 'the file is damaged: it is neither a text STL file nor as long as a binary one with its triangles');
    const text = textAt(buffer, buffer.byteLength);
    check(/endsolid/.test(text), 'the file ends early: endsolid is missing');
    reader.parseAsText(text);
  }
  return surfaceOf(reader.getOutputData());
}

function readPly(buffer) {
  const header = textAt(buffer, 100000).split('end_header')[0];
  check(/^ply\r?\n/.test(header) && header.length < Math.min(100000, buffer.byteLength), 'the file is damaged: it has no PLY header');
  const reader = vtkPLYReader.newInstance({ duplicatePointsForFaceTexture: false });
  try {
    reader.parseAsArrayBuffer(buffer);
  } catch (error) {
    throw new Error(`the file is damaged or ends early (${error.message})`);
  }
  return surfaceOf(reader.getOutputData());
}

/** What the page reads, by the ending of the name. */
const READERS = {
  '.stl': (buffer) => ({ surface: readStl(buffer) }),
  '.ply': (buffer) => ({ surface: readPly(buffer) }),
  '.nii': (buffer) => ({ map: readLabelMap(buffer) }),
  '.nii.gz': (buffer) => ({ map: readLabelMap(buffer) }),
};
const ENDINGS = Object.keys(READERS);

/** For the attribute of an input: browsers know the part of an ending behind its last dot alone. */
export const ACCEPTED = ENDINGS.map((ending) => ending.slice(ending.lastIndexOf('.'))).join(',');

/** @returns { surface } or { map }. Throws an Error with one sentence. */
export async function readFile(file) {
  const name = file.name.toLowerCase();
  const ending = ENDINGS.find((one) => name.endsWith(one));
  check(ending, `this page reads STL, PLY and NIfTI label maps (${ENDINGS.join(', ')})`);
  return READERS[ending](await file.arrayBuffer());
}

function polyDataOf({ points, triangles }) {
  const cells = new Uint32Array((4 * triangles.length) / 3);
  for (let i = 0, j = 0; i < triangles.length; i += 3) {
    cells.set([3, triangles[i], triangles[i + 1], triangles[i + 2]], j);
    j += 4;
  }
  const polydata = vtkPolyData.newInstance();
  polydata.setPoints(vtkPoints.newInstance({ values: points, numberOfComponents: 3 }));
  polydata.setPolys(vtkCellArray.newInstance({ values: cells }));
  return polydata;
}

/** Binary. The writer of vtk.js keeps six digits of a coordinate, but the certificate is one of all bits. */
function writeStl({ points, triangles }) {
  const count = triangles.length / 3;
  const data = new DataView(new ArrayBuffer(STL_HEADER + STL_TRIANGLE * count));
  data.setUint32(STL_HEADER - 4, count, true);
  for (let t = 0; t < count; ++t) {
    const corners = [0, 1, 2].map((i) => points.subarray(3 * triangles[3 * t + i], 3 * triangles[3 * t + i] + 3));
    const [a, b, c] = corners;
    const [u, v] = [b, c].map((end) => end.map((x, axis) => x - a[axis]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...normal) || 1;
    const numbers = [...normal.map((x) => x / length), ...a, ...b, ...c];
    numbers.forEach((x, i) => data.setFloat32(STL_HEADER + STL_TRIANGLE * t + 4 * i, x, true));
  }
  return data;
}

/** The bytes of a binary file of a surface in single precision. @param format 'stl' or 'ply'. */
export function bytesOf(surface, format) {
  const names = TextureCoordinatesName.UV;
  return format === 'stl'
    ? writeStl(surface)
    : vtkPLYWriter.writePLY(polyDataOf(surface), FormatTypes.BINARY, 0, [], null, names, null, false, false, false, true);
}
