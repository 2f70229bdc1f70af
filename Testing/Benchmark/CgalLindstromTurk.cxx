// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CgalLindstromTurk.cxx
 * @brief One decimation by CGAL's edge collapse with its default policies (Lindstrom and Turk
 * 1998), memoryless.
 *
 *     bonedecimate-cgal INPUT.ply OUTPUT.ply FACES|MMmm
 *
 * Uses CGAL's Surface_mesh_simplification (GPL-3.0-or-later), which makes this program GPL: a
 * contestant of the benchmark, never installed. CGAL counts edges and a collapse takes three, or
 * two at a boundary: it is stopped at the first edge count that goes with the requested faces on a
 * closed surface, and ends somewhat lower on an open one. With a length in mm it collapses what
 * Polyhedral_envelope_filter lets it.
 */
#include "CgalMesh.h"
#include "CgalTriangles.h"
#include "Meter.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Polyhedral_envelope_filter.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace
{
namespace Simplification = CGAL::Surface_mesh_simplification;

template <typename Kernel, typename... Parameters>
void Run(char** words, std::size_t edges, const Parameters&... parameters)
{
  Meter meter;
  auto mesh = MeshOf<typename Kernel::Point_3>(ReadPly(words[1]));
  meter.Start();
  Simplification::edge_collapse(
    mesh, Simplification::Count_stop_predicate<decltype(mesh)>(edges), parameters...);
  meter.Stop();
  WriteResult(words[2], mesh, meter);
}
}

int main(int argumentCount, char** words)
{
  if (argumentCount != 4)
  {
    std::fputs("usage: bonedecimate-cgal INPUT.ply OUTPUT.ply FACES|MMmm\n", stderr);
    return EXIT_FAILURE;
  }
  try
  {
    const double goal = std::atof(words[3]);
    if (std::string(words[3]).find("mm") == std::string::npos)
    {
      Run<CGAL::Simple_cartesian<double>>(words, static_cast<std::size_t>(1.5 * goal));
      return EXIT_SUCCESS;
    }
    using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
    const Simplification::Polyhedral_envelope_filter<Exact> envelope(goal);
    Run<Exact>(words, 0, CGAL::parameters::filter(envelope));
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-cgal: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
