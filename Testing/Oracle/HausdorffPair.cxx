// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HausdorffPair.cxx
 * @brief bonedecimate-hausdorff: our certificate of two surfaces beside CGAL's bounded-error
 * Hausdorff distance.
 *
 *     bonedecimate-hausdorff REFERENCE.ply RESULT.ply [ERROR in mm, default 0.0001]
 *
 * Prints JSON. CGAL's figure is the distance in each direction within the error. Both use one
 * thread; seconds are those of the processor.
 */
#include "CgalMesh.h"
#include "Proof/Certificate/Certificate.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

namespace
{
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

double SecondsSince(std::clock_t start)
{
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

bonedecimate::Surface SurfaceOf(const Triangles& triangles)
{
  bonedecimate::Surface surface;
  for (const auto& [x, y, z] : triangles.Points)
  {
    surface.Points.emplace_back(x, y, z);
  }
  surface.Triangles.assign(triangles.Corners.begin(), triangles.Corners.end());
  return surface;
}

void PrintOurs(const Triangles& reference, const Triangles& result)
{
  bonedecimate::CertificateOptions options;
  options.NumberOfThreads = 1;
  const std::clock_t start = std::clock();
  const bonedecimate::Certificate found =
    bonedecimate::Certify(SurfaceOf(reference), SurfaceOf(result), options);
  const bonedecimate::DistanceBounds& there = found.ReferenceToResult.Distance;
  const bonedecimate::DistanceBounds& back = found.ResultToReference.Distance;
  std::printf("{\"ours\": {\"reference_to_result\": [%.17g, %.17g], "
              "\"result_to_reference\": [%.17g, %.17g], \"cpu_seconds\": %.3f},\n",
    there.Lower, there.Upper, back.Lower, back.Upper, SecondsSince(start));
}

void PrintCgal(const Triangles& reference, const Triangles& result, double error)
{
  const auto one = MeshOf<Point>(reference);
  const auto two = MeshOf<Point>(result);
  namespace Processing = CGAL::Polygon_mesh_processing;
  const std::clock_t start = std::clock();
  const double there =
    Processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(one, two, error);
  const double back =
    Processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(two, one, error);
  std::printf(" \"cgal\": {\"reference_to_result\": %.17g, \"result_to_reference\": %.17g, "
              "\"error\": %.17g, \"cpu_seconds\": %.3f}}\n",
    there, back, error, SecondsSince(start));
}
}

int main(int argumentCount, char** words)
{
  if (argumentCount < 3 || argumentCount > 4)
  {
    std::fputs("usage: bonedecimate-hausdorff REFERENCE.ply RESULT.ply [ERROR]\n", stderr);
    return EXIT_FAILURE;
  }
  try
  {
    const Triangles reference = ReadPly(words[1]);
    const Triangles result = ReadPly(words[2]);
    PrintOurs(reference, result);
    std::fflush(stdout);
    PrintCgal(reference, result, argumentCount > 3 ? std::atof(words[3]) : 1e-4);
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-hausdorff: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
