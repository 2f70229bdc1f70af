// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Runs.h
 * @brief Common options of tests, and tests that run once for each shape.
 */
#ifndef BoneDecimate_Testing_Runs_h
#define BoneDecimate_Testing_Runs_h

#include "BruteForce.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Run/Decimate.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace bonedecimate::testsupport
{
/// Without measuring, which takes longer than anything else on small shapes.
inline Options Unmeasured()
{
  Options options;
  options.MeasureDistances = false;
  options.NumberOfThreads = 1;
  return options;
}

inline Options Reduction(double fraction)
{
  Options options = Unmeasured();
  options.TargetReduction = fraction;
  options.TargetReductionIsExplicit = true;
  return options;
}

inline Options Triangles(int number)
{
  Options options = Unmeasured();
  options.TargetNumberOfTriangles = number;
  return options;
}

inline Options Error(double millimeters)
{
  Options options = Unmeasured();
  options.MaximumError = millimeters;
  return options;
}

/// Some shapes are no larger than the errors that all of them are given.
inline Options ErrorOfAnySize(double millimeters)
{
  Options options = Error(millimeters);
  options.AllowLargeError = true;
  return options;
}

inline Options InMode(Mode mode, Options options)
{
  options.Mode = mode;
  return options;
}

inline std::vector<Mode> AllModes()
{
  std::vector<Mode> modes;
  for (const ModeInfo& mode : ModeTable())
  {
    modes.push_back(mode.Mode);
  }
  return modes;
}

/// Modes that keep a largest error and prove it.
inline std::vector<Mode> ProvingModes()
{
  std::vector<Mode> modes;
  for (const ModeInfo& mode : ModeTable())
  {
    if (mode.ProvesError())
    {
      modes.push_back(mode.Mode);
    }
  }
  return modes;
}

inline std::string WordOf(Mode mode)
{
  return FindMode(mode).Name;
}

/// Whether cleaning drops no triangle: dropped ones may be at any distance.
inline bool CanBeCertified(const Surface& input)
{
  const Report report = Decimate(input, Triangles(std::numeric_limits<int>::max())).Report;
  return report.Status == InputStatus::Good && report.Cleaning.DroppedTriangles == 0;
}

/// Expects the bytes of one thread also from several threads.
inline void ExpectTheSameBytesForAnyNumberOfThreads(
  const Surface& input, Options options, const std::vector<double>* tolerances = nullptr)
{
  options.NumberOfThreads = 1;
  const Surface expected = Decimate(input, options, {}, { false, false, tolerances }).Surface;
  for (const int threads : { 2, 4, 8 })
  {
    options.NumberOfThreads = threads;
    EXPECT_TRUE(
      SameBytes(Decimate(input, options, {}, { false, false, tolerances }).Surface, expected))
      << WordOf(options.Mode) << " on " << threads << " threads, " << expected.Triangles.size()
      << " triangles left";
  }
}

/// With all points, those too that are used no more.
inline Surface SurfaceOf(const HalfEdgeMesh& mesh)
{
  Surface surface;
  for (Index v = 0; v < mesh.NumberOfVertexSlots(); ++v)
  {
    surface.Points.push_back(mesh.Position(v));
  }
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (mesh.IsAlive(face))
    {
      surface.Triangles.push_back(mesh.Corners(face));
    }
  }
  return surface;
}

/// Every half-edge of a mesh, or every n-th of them.
inline std::vector<Index> HalfEdges(const HalfEdgeMesh& mesh, Index step = 1)
{
  std::vector<Index> halfEdges;
  for (Index i = 0; i < 3 * mesh.NumberOfFaceSlots(); i += step)
  {
    halfEdges.push_back(HalfEdgeMesh::HalfEdge(i / 3, i % 3));
  }
  return halfEdges;
}

/// Printed by GoogleTest as the value of the parameter.
inline void PrintTo(const NamedSurface& shape, std::ostream* stream)
{
  *stream << shape.Name;
}

inline std::string NameOf(const testing::TestParamInfo<NamedSurface>& info)
{
  return info.param.Name;
}

class EachShape : public testing::TestWithParam<NamedSurface>
{
};
}

#endif
