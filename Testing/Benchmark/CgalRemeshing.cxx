// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CgalRemeshing.cxx
 * @brief One isotropic remeshing by CGAL with its default settings, of ten iterations as MeshLab's.
 *
 *     bonedecimate-cgal-remeshing INPUT.ply OUTPUT.ply LENGTH
 *
 * Uses CGAL's Polygon_mesh_processing (GPL-3.0-or-later), which makes this program GPL: a peer of
 * the benchmark, never installed.
 */
#include "CgalMesh.h"
#include "CgalTriangles.h"
#include "Meter.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int argumentCount, char** words)
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  namespace Processing = CGAL::Polygon_mesh_processing;
  if (argumentCount != 4)
  {
    std::fputs("usage: bonedecimate-cgal-remeshing INPUT.ply OUTPUT.ply LENGTH\n", stderr);
    return EXIT_FAILURE;
  }
  try
  {
    Meter meter;
    CGAL::Surface_mesh<Point> mesh = MeshOf<Point>(ReadPly(words[1]));
    meter.Start();
    Processing::isotropic_remeshing(
      faces(mesh), std::atof(words[3]), mesh, Processing::parameters::number_of_iterations(10));
    meter.Stop();
    WriteResult(words[2], mesh, meter);
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-cgal-remeshing: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
