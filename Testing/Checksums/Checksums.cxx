// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Checksums.cxx
 * @brief bonedecimate-checksums: one line of checksums for each shape and set of options, one
 * checksum for each mode.
 *
 *     bonedecimate-checksums [--short | SURFACE.ply ...]
 *
 * Without files the shapes of the tests (--short: two sets of options for each), with files these
 * surfaces at fewer options. A checksum covers the points, the triangles, every array of the result
 * and the counts of its report. Two versions with the same lines give the same results.
 */
#include "ChecksumRuns.h"
#include "TriangleFile.h"

#include <cstdio>
#include <exception>
#include <filesystem>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
void PrintLines(const NamedSurface& shape, const std::vector<ChecksumCase>& cases)
{
  for (const ChecksumCase& one : cases)
  {
    std::printf("%-20s %-17s", shape.Name.c_str(), one.Name.c_str());
    for (const ModeInfo& mode : ModeTable())
    {
      const std::uint64_t sum = ChecksumOfRun(shape.Surface, one, mode.Mode);
      std::printf(" %016llx", static_cast<unsigned long long>(sum));
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

/// Two cases of each shape, so that all cases come up.
void PrintShortForm()
{
  constexpr std::size_t step = 11;
  const std::vector<NamedSurface> shapes = ShapesOfChecksums();
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const std::vector<ChecksumCase> all = CasesOfShapes(shapes[i].Surface);
    std::vector<ChecksumCase> some;
    for (std::size_t j = i % step; j < all.size(); j += step)
    {
      some.push_back(all[j]);
    }
    PrintLines(shapes[i], some);
  }
}

Surface Read(const char* path)
{
  const Triangles read = ReadPly(path);
  Surface surface;
  for (const std::array<double, 3>& p : read.Points)
  {
    surface.Points.emplace_back(p[0], p[1], p[2]);
  }
  surface.Triangles.assign(read.Corners.begin(), read.Corners.end());
  return surface;
}
}

int main(int argc, char** argv)
{
  try
  {
    if (argc == 2 && std::string(argv[1]) == "--short")
    {
      PrintShortForm();
      return 0;
    }
    for (int i = 1; i < argc; ++i)
    {
      const Surface surface = Read(argv[i]);
      PrintLines(
        { std::filesystem::path(argv[i]).stem().string(), surface }, CasesOfLarge(surface));
    }
    if (argc == 1)
    {
      for (const NamedSurface& shape : ShapesOfChecksums())
      {
        PrintLines(shape, CasesOfShapes(shape.Surface));
      }
      const NamedSurface large = LargeShapeOfChecksums();
      PrintLines(large, CasesOfLarge(large.Surface));
    }
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
