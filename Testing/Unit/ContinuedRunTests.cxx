// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// A run that continues another: its error refers to the original of both, and its certificate to
// what it has changed.
#include "LabelMaps.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Partition/Slabs/ContinuedProof.h"
#include "Run/Decimate.h"
#include "Runs.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bonedecimate::testsupport
{
namespace
{
Options FastError(double error)
{
  Options options = InMode(Mode::Fast, Error(error));
  options.KeepVoxels = KeepVoxels::Off;
  return options;
}

/// A run that continues one that has changed nothing.
Result Continue(const Surface& surface, const LabelMapSource* labels, const Options& options)
{
  SurfacePart part;
  part.Reference = &surface;
  part.ReferenceLabels = labels;
  RunInputs inputs;
  inputs.LabelMap = labels;
  inputs.Part = &part;
  return Decimate(surface, options, {}, inputs);
}
}

TEST(ContinuedRun, LeavesAsFewTrianglesAsADirectOne)
{
  const Surface field = HeightField(30, 0.2, 5);
  const Options options = FastError(0.3);
  const std::size_t direct = Decimate(field, options).Surface.Triangles.size();
  EXPECT_LE(Continue(field, nullptr, options).Surface.Triangles.size(), direct + direct / 10);
}

/// Patches meet at their boundaries: each has to find its own there.
TEST(ContinuedRun, LeavesAsFewTrianglesAsADirectOneBetweenLabels)
{
  const LabelMap map = EllipsoidLabels({ 24, 20, 22 });
  const LabelSurfaces walls = ExtractLabelSurfaces(MakeLabelImage(map.Labels.data(), map.Grid), {});
  const Options options = FastError(0.5);
  RunInputs inputs;
  inputs.LabelMap = &walls.Source;
  const std::size_t direct = Decimate(walls.Surface, options, {}, inputs).Surface.Triangles.size();
  EXPECT_LT(direct, walls.Surface.Triangles.size() / 4);
  EXPECT_LE(
    Continue(walls.Surface, &walls.Source, options).Surface.Triangles.size(), direct + direct / 10);
}

TEST(ContinuedProof, ComparesWhatHasChanged)
{
  const Surface grid = Grid(6);
  Surface raised = grid;
  raised.Points[0].z() = 0.25;
  const Options options = FastError(0.3);
  const ContinuedProof proof = ProveContinued({ grid, grid, grid, raised }, options, true, {});
  EXPECT_EQ(proof.Status, ProofStatus::Proved);
  EXPECT_GE(proof.ResultToOriginal.Upper, 0.25);
  EXPECT_LE(proof.ResultToOriginal.Upper, 0.3);
  ASSERT_EQ(proof.Bounds.size(), raised.Points.size());
  EXPECT_GE(proof.Bounds[0], 0.25);
  EXPECT_TRUE(std::isnan(proof.Bounds.back())); // no triangle around it has changed
  EXPECT_EQ(
    ProveContinued({ grid, grid, raised, raised }, options, false, {}).ResultToOriginal.Upper, 0.0);
  EXPECT_EQ(ProveContinued({ grid, grid, grid, raised }, FastError(0.2), false, {}).Status,
    ProofStatus::Violated);
}
}
