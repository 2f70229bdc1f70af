// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
import vtkActor from '@kitware/vtk.js/Rendering/Core/Actor';
import vtkDataArray from '@kitware/vtk.js/Common/Core/DataArray';
import vtkMapper from '@kitware/vtk.js/Rendering/Core/Mapper';
import vtkPolyData from '@kitware/vtk.js/Common/DataModel/PolyData';
import vtkProperty from '@kitware/vtk.js/Rendering/Core/Property';

import { pointNormals } from './normals.js';

const BONE = [0.93, 0.87, 0.76];
const INSIDE = [0.6, 0.46, 0.42]; // back faces, seen where a plane cuts the surface
const EDGES = [0.42, 0.34, 0.26];

function makePolyData(piece, colors) {
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
    polydata.getPointData().setScalars(distanceColors(piece.distances, colors));
  }
  return polydata;
}

/** Colors of points as bytes, from the table of the page: a color for each of the 256 steps of a distance. */
function distanceColors(distances, colors) {
  const values = new Uint8Array(3 * distances.length);
  for (let i = 0; i < distances.length; ++i) {
    values.set(colors[distances[i]], 3 * i);
  }
  return vtkDataArray.newInstance({ name: 'Distance', numberOfComponents: 3, values });
}

class Piece {
  constructor(data, scene) {
    this.parts = data.parts;
    this.points = data.points;
    this.triangles = data.triangles;
    this.hasDistances = data.distances !== null;
    this.colors = data.parts.map((part) => scene.parts[part].color || BONE);
    // Mappers without a list of their own have one in common.
    this.mapper = vtkMapper.newInstance({ clippingPlanes: [] });
    this.mapper.setInputData(makePolyData(data, scene.distances ? scene.distances.colors : null));
    this.mapper.setScalarModeToUsePointData();
    this.mapper.setColorModeToDirectScalars();
    this.actor = vtkActor.newInstance();
    this.actor.setMapper(this.mapper);
    this.inside = vtkProperty.newInstance({ diffuseColor: INSIDE, ambientColor: INSIDE, ambient: 0.25, diffuse: 0.7, specular: 0 });
  }

  show(look) {
    const property = this.actor.getProperty();
    const isColored = look.distances && this.hasDistances;
    const first = this.parts.findIndex((part) => look.parts[part]);
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
