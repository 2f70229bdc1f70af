// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkLookupTable from '@kitware/vtk.js/Common/Core/LookupTable';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkProperty from '@kitware/vtk.js/Rendering/Core/Property';

import { pointNormals } from './normals.js';

const BONE = [0.93, 0.87, 0.76];
const INSIDE = [0.6, 0.46, 0.42]; // back faces, seen where a plane cuts the surface
const EDGES = [0.42, 0.34, 0.26];

function makePolyData(piece) {
  const polydata = vtkPolyData.newInstance();
  polydata.getPoints().setData(piece.points, 3);
  const cells = new Uint32Array((piece.triangles.length / 3) * 4);
  for (let i = 0, j = 0; i < piece.triangles.length; i += 3) {
    cells[j++] = 3;
    cells[j++] = piece.triangles[i];
    cells[j++] = piece.triangles[i + 1];
    cells[j++] = piece.triangles[i + 2];
  }
  polydata.getPolys().setData(cells);
  const values = pointNormals(piece.points, piece.triangles);
  polydata.getPointData().setNormals(vtkDataArray.newInstance({ name: 'Normals', numberOfComponents: 3, values }));
  if (piece.distances) {
    polydata.getPointData().setScalars(vtkDataArray.newInstance({ name: 'Distance', values: piece.distances }));
  }
  return polydata;
}

/** The color of each of the 256 steps of a distance; those below the threshold are plain. */
function colorTable(colors, threshold, plain) {
  return colors.map((color, step) => [...(step < threshold ? plain : color), 255]);
}

class Piece {
  constructor(data, scene) {
    this.parts = data.parts;
    this.points = data.points;
    this.triangles = data.triangles;
    this.distances = data.distances;
    this.table = scene.distances?.colors;
    this.colors = data.parts.map((part) => scene.parts[part].color || BONE);
    // Mappers without a list of their own have one in common.
    this.mapper = vtkMapper.newInstance({ clippingPlanes: [] });
    this.mapper.setInputData(makePolyData(data));
    this.mapper.setScalarModeToUsePointData();
    // Distances are interpolated, and not their colors: a threshold ends where the distance does.
    this.mapper.setColorModeToMapScalars();
    this.mapper.setInterpolateScalarsBeforeMapping(true);
    this.mapper.setScalarRange(0, 255);
    this.mapper.setLookupTable(vtkLookupTable.newInstance());
    this.actor = vtkActor.newInstance();
    this.actor.setMapper(this.mapper);
    this.inside = vtkProperty.newInstance({ diffuseColor: INSIDE, ambientColor: INSIDE, ambient: 0.25, diffuse: 0.7, specular: 0 });
  }

  show(look) {
    const property = this.actor.getProperty();
    const isColored = look.distances && this.distances !== null;
    const first = this.parts.findIndex((part) => look.parts[part]);
    if (isColored) {
      this.colorByDistance(look.threshold, this.colors[Math.max(first, 0)]);
    }
    this.actor.setVisibility(look.isVisible && first >= 0);
    property.setColor(...this.colors[Math.max(first, 0)]);
    // Less shadow and no shine under colors that are to be read off.
    property.setAmbient(isColored ? 0.3 : 0.1);
    property.setDiffuse(isColored ? 0.75 : 0.9);
    property.setSpecular(isColored ? 0 : 0.1);
    property.setSpecularPower(18);
    property.setEdgeVisibility(look.triangles);
    property.setEdgeColor(EDGES);
    property.setLineWidth(1);
    if (look.triangles) {
      property.setInterpolationToFlat();
    } else {
      property.setInterpolationToPhong();
    }
    this.actor.setBackfaceProperty(look.isCut && !isColored ? this.inside : null);
    this.mapper.setScalarVisibility(isColored);
  }

  colorByDistance(threshold, color) {
    const plain = color.map((value) => Math.round(255 * value));
    const key = [threshold, ...plain].join();
    if (key !== this.colored) {
      this.colored = key;
      this.mapper.getLookupTable().setTable(colorTable(this.table, threshold, plain));
      this.mapper.modified();
    }
  }

  clip(planes) {
    this.mapper.removeAllClippingPlanes();
    planes.forEach((plane) => this.mapper.addClippingPlane(plane));
  }
}

/** A surface of the page in a renderer: an actor for each piece. */
export class Surface {
  constructor(pieces, scene, renderer) {
    this.pieces = pieces.map((piece) => new Piece(piece, scene));
    this.pieces.forEach((piece) => renderer.addActor(piece.actor));
  }

  show(look) {
    this.pieces.forEach((piece) => piece.show(look));
  }

  clip(planes) {
    this.pieces.forEach((piece) => piece.clip(planes));
  }

  visiblePieces() {
    return this.pieces.filter((piece) => piece.actor.getVisibility());
  }
}
