// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CgalMesh.h
 * @brief Converts triangles to a mesh of CGAL. Points of non-manifold parts are duplicated, which
 * changes no position.
 *
 * Uses CGAL's Polygon_mesh_processing (GPL-3.0-or-later): only for programs that are never
 * installed.
 */
#ifndef BoneDecimate_Testing_CgalMesh_h
#define BoneDecimate_Testing_CgalMesh_h

#include "TriangleFile.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

template <typename Point>
CGAL::Surface_mesh<Point> MeshOf(const Triangles& triangles)
{
  std::vector<Point> points;
  for (const auto& [x, y, z] : triangles.Points)
  {
    points.emplace_back(x, y, z);
  }
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& corners : triangles.Corners)
  {
    polygons.emplace_back(corners.begin(), corners.end());
  }
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons);
  CGAL::Surface_mesh<Point> mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return mesh;
}

#endif
