// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CgalLindstromTurk.cxx
 * @brief One decimation by CGAL's edge collapse with its default policies (Lindstrom and Turk
 * 1998), memoryless.
 *
 *     bonedecimate-cgal INPUT.ply OUTPUT.ply FACES
 *
 * Uses CGAL's Surface_mesh_simplification (GPL-3.0-or-later), which makes this program GPL: a
 * contestant of the benchmark, never installed. CGAL counts edges and a collapse takes three, or
 * two at a boundary: it is stopped at the first edge count that goes with the requested faces on a
 * closed surface, and ends somewhat lower on an open one.
 */
#include "CgalMesh.h"
#include "CgalTriangles.h"
#include "Meter.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace
{
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace Simplification = CGAL::Surface_mesh_simplification;
}

int main(int argumentCount, char** words)
{
  if (argumentCount != 4)
  {
    std::fputs("usage: bonedecimate-cgal INPUT.ply OUTPUT.ply FACES\n", stderr);
    return EXIT_FAILURE;
  }
  try
  {
    Meter meter;
    Mesh mesh = MeshOf<Point>(ReadPly(words[1]));
    const auto edges = static_cast<std::size_t>(1.5 * std::atof(words[3]));
    meter.Start();
    Simplification::edge_collapse(mesh, Simplification::Count_stop_predicate<Mesh>(edges));
    meter.Stop();
    WriteResult(words[2], mesh, meter);
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-cgal: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
