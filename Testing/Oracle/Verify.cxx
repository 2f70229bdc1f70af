// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Verify.cxx
 * @brief bonedecimate-verify: measures two surfaces and their distances independently of the core.
 *
 *     bonedecimate-verify ORIGINAL.ply SIMPLIFIED.ply [--samples N] [--threads N] [--shape]
 *
 * Prints JSON. With --shape the first surface alone is described and nothing is compared.
 */
#include "Distances.h"
#include "SelfIntersections.h"
#include "Shape.h"
#include "TriangleFile.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>

namespace
{
struct Arguments
{
  std::string Original;
  std::string Simplified;
  std::size_t Samples = 200000;
  unsigned Threads = std::max(1U, std::thread::hardware_concurrency());
  bool ShapeOnly = false;
};

bool Understand(int count, char** words, Arguments& arguments)
{
  for (int i = 1; i < count; ++i)
  {
    const std::string word = words[i];
    const bool hasNumber = i + 1 < count && std::atol(words[i + 1]) > 0;
    if (word == "--shape")
    {
      arguments.ShapeOnly = true;
    }
    else if (word == "--samples" && hasNumber)
    {
      arguments.Samples = static_cast<std::size_t>(std::atol(words[++i]));
    }
    else if (word == "--threads" && hasNumber)
    {
      arguments.Threads = static_cast<unsigned>(std::atol(words[++i]));
    }
    else if (word.rfind("--", 0) != 0 && arguments.Simplified.empty())
    {
      (arguments.Original.empty() ? arguments.Original : arguments.Simplified) = word;
    }
    else
    {
      return false;
    }
  }
  return !arguments.Original.empty() && arguments.ShapeOnly == arguments.Simplified.empty();
}

void PrintDistances(const char* name, const Distances& d)
{
  std::printf(",\n \"%s\": {\"average\": %.9g, \"rms\": %.9g, \"maximum\": %.9g, "
              "\"point_average\": %.9g, \"point_rms\": %.9g, \"point_maximum\": %.9g, "
              "\"point_second\": %.9g,\n  \"percentiles\": [",
    name, d.Average, d.RootMeanSquare, d.Maximum, d.PointAverage, d.PointRootMeanSquare,
    d.PointMaximum, d.PointSecond);
  for (std::size_t i = 0; i < d.Percentiles.size(); ++i)
  {
    std::printf("%s%.6g", i == 0 ? "" : ", ", d.Percentiles[i]);
  }
  std::printf("]}");
}

void PrintShape(const Triangles& surface)
{
  const Triangles welded = Welded(surface);
  const Shape shape = MeasureShape(welded);
  std::printf(
    "{\"triangles\": %zu, \"components\": %lld, \"boundary_edges\": %lld, "
    "\"non_manifold_edges\": %lld, \"non_manifold_vertices\": %lld, \"euler\": %lld,\n "
    "\"quality\": %.6f, \"bad_fraction\": %.6f, \"below_10_20_30_degrees\": [%lld, %lld, %lld], "
    "\"degenerate\": %lld, \"self_intersections\": %lld",
    surface.Corners.size(), static_cast<long long>(shape.Components),
    static_cast<long long>(shape.BoundaryEdges), static_cast<long long>(shape.NonManifoldEdges),
    static_cast<long long>(shape.NonManifoldVertices), static_cast<long long>(shape.EulerNumber),
    shape.Quality, shape.BadFraction, static_cast<long long>(shape.SmallAngles[0]),
    static_cast<long long>(shape.SmallAngles[1]), static_cast<long long>(shape.SmallAngles[2]),
    static_cast<long long>(shape.Degenerate),
    static_cast<long long>(CountSelfIntersections(welded)));
}

void Run(const Arguments& arguments)
{
  const Triangles original = ReadPly(arguments.Original);
  if (arguments.ShapeOnly)
  {
    PrintShape(original);
  }
  else
  {
    const Triangles simplified = ReadPly(arguments.Simplified);
    PrintShape(simplified);
    const Distances there =
      MeasureDistances(simplified, original, arguments.Samples, arguments.Threads);
    const Distances back =
      MeasureDistances(original, simplified, arguments.Samples, arguments.Threads);
    PrintDistances("simplified_to_original", there);
    PrintDistances("original_to_simplified", back);
    std::printf(",\n \"hausdorff\": %.9g", std::max(there.Maximum, back.Maximum));
  }
  std::printf("}\n");
}
}

int main(int argumentCount, char** words)
{
  Arguments arguments;
  if (!Understand(argumentCount, words, arguments))
  {
    std::fputs(
      "usage: bonedecimate-verify ORIGINAL.ply SIMPLIFIED.ply [--samples N] [--threads N]\n"
      "       bonedecimate-verify --shape SURFACE.ply\n",
      stderr);
    return EXIT_FAILURE;
  }
  try
  {
    Run(arguments);
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-verify: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
