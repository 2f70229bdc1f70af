// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CgalTriangles.h
 * @brief Writes a mesh of CGAL and prints what the benchmark reads. Only for programs that are
 * never installed.
 */
#ifndef BoneDecimate_Testing_CgalTriangles_h
#define BoneDecimate_Testing_CgalTriangles_h

#include "Meter.h"
#include "TriangleFile.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <cstdint>
#include <cstdio>

template <typename Point>
Triangles ToTriangles(CGAL::Surface_mesh<Point>& mesh)
{
  mesh.collect_garbage();
  Triangles result;
  for (const auto vertex : mesh.vertices())
  {
    const Point& x = mesh.point(vertex);
    result.Points.push_back({ x[0], x[1], x[2] });
  }
  for (const auto face : mesh.faces())
  {
    std::array<std::int32_t, 3> corners{};
    std::size_t k = 0;
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
    {
      corners[k++] = static_cast<std::int32_t>(vertex.idx());
    }
    result.Corners.push_back(corners);
  }
  return result;
}

template <typename Point>
void WriteResult(const char* file, CGAL::Surface_mesh<Point>& mesh, const Meter& meter)
{
  const Triangles result = ToTriangles(mesh);
  WritePly(file, result, Coordinates::Double);
  std::printf(
    "{\"triangles\": %zu, \"version\": \"%s\", ", result.Corners.size(), CGAL_VERSION_STR);
  meter.Print();
  std::printf("}\n");
}

#endif
