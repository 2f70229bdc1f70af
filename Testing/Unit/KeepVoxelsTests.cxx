// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
// Whole runs on surfaces of label maps: no voxel changes where voxels are guarded, and the check
// sees it where they are not.
#include "BruteForce.h"
#include "LabelMaps.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Labels/LabelMap/VoxelCheck.h"
#include "NoisyBones.h"
#include "Proof/Certificate/Certificate.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
RunInputs With(const LabelSurfaces& surfaces)
{
  RunInputs inputs;
  inputs.LabelMap = &surfaces.Source;
  return inputs;
}

Options Keeping(Options options)
{
  options.KeepVoxels = KeepVoxels::On;
  return options;
}

Options Free(Options options)
{
  options.KeepVoxels = KeepVoxels::Off;
  return options;
}

double Spacing(const LabelMap& map)
{
  return map.Grid.Spacing.minCoeff();
}

/// By the voxelizer of the tests, along three axes.
std::int64_t WrongVoxels(const LabelMap& map, const LabelSurfaces& surfaces, const Result& result)
{
  std::int64_t wrong = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<Index> labels = VoxelizeLabels(result.Surface, result.BoundaryLabels,
      surfaces.Source.Grid, surfaces.Source.Background(), axis);
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
      const bool isRight = labels[i] != NoLabel &&
        surfaces.Source.Values[static_cast<std::size_t>(labels[i])] == map.Labels[i];
      wrong += isRight ? 0 : 1;
    }
  }
  return wrong;
}

class EachMap : public testing::TestWithParam<Map>
{
protected:
  const LabelMap& Voxels = GetParam().Voxels;
  LabelSurfaces Surfaces = Extracted(this->Voxels);

  Result Run(const Options& options) const
  {
    Result result = Decimate(this->Surfaces.Surface, options, {}, With(this->Surfaces));
    EXPECT_EQ(result.Report.Status, InputStatus::Good) << InputMessage(result.Report);
    return result;
  }
  Result ExpectAllKept(const Options& options) const
  {
    const Result result = this->Run(options);
    EXPECT_LT(result.Surface.Triangles.size(), this->Surfaces.Surface.Triangles.size());
    EXPECT_TRUE(result.Report.Voxels.WereGuarded);
    EXPECT_TRUE(result.Report.Voxels.WasChecked);
    EXPECT_EQ(result.Report.Voxels.Changes.Changed, 0) << WordOf(options.Mode);
    EXPECT_EQ(WrongVoxels(this->Voxels, this->Surfaces, result), 0) << WordOf(options.Mode);
    const VoxelChanges byMap =
      CompareVoxels(MakeLabelImage(this->Voxels.Labels.data(), this->Voxels.Grid),
        this->Surfaces.Source.Values, { result.Surface, result.BoundaryLabels },
        { {}, static_cast<Index>(this->Surfaces.Source.Values.size()), 1 });
    EXPECT_TRUE(byMap.IsDone);
    EXPECT_EQ(byMap.Changed, 0) << WordOf(options.Mode);
    return result;
  }
};

std::string NameOfMap(const testing::TestParamInfo<Map>& info)
{
  return info.param.Name;
}
}

TEST_P(EachMap, KeepsEveryVoxelInEveryModeWithABound)
{
  for (const Mode mode : AllModes())
  {
    this->ExpectAllKept(InMode(mode, Keeping(ErrorOfAnySize(0.5 * Spacing(this->Voxels)))));
  }
  for (const double voxels : { 0.25, 1.0 })
  {
    this->ExpectAllKept(
      InMode(Mode::Fast, Keeping(ErrorOfAnySize(voxels * Spacing(this->Voxels)))));
  }
}

TEST_P(EachMap, KeepsEveryVoxelInEveryModeWithoutABound)
{
  for (const Mode mode : AllModes())
  {
    this->ExpectAllKept(InMode(mode, Keeping(Unmeasured())));
    this->ExpectAllKept(InMode(mode, Keeping(Reduction(0.5))));
  }
}

class SomeMap : public EachMap // smoothed runs take longer
{
};

TEST_P(SomeMap, KeepsEveryVoxelAndTheBoundInEveryModeThatSmoothsFirst)
{
  const double spacing = Spacing(this->Voxels);
  const double error = 0.4 * spacing;
  for (const Mode mode : AllModes())
  {
    const bool isProved = FindMode(mode).ProvesError();
    Options options = InMode(mode, Keeping(isProved ? ErrorOfAnySize(error) : Reduction(0.5)));
    options.Smoothing = 0.3 * spacing;
    options.ProveResult = false; // the certificate is called here
    const Result result = this->ExpectAllKept(options);
    EXPECT_GT(result.Report.Smoothing.MaxDisplacement, 0.1 * spacing);
    EXPECT_LT(result.Report.Smoothing.AngleAfter, result.Report.Smoothing.AngleBefore);
    CertificateOptions certified;
    certified.Tolerance = error;
    certified.NumberOfThreads = 1;
    certified.TightBounds = false;
    certified.WithMeans = false;
    EXPECT_TRUE(!isProved ||
      Certify(this->Surfaces.Surface, result.Surface, certified).Proof == ProofStatus::Proved);
  }
}

TEST_P(EachMap, KeepsEveryVoxelInSinglePrecision)
{
  Options options = Keeping(Unmeasured());
  options.OutputPointsPrecision = PointsPrecision::Single;
  this->ExpectAllKept(options);
}

TEST_P(EachMap, HasTheSameBytesForAnyNumberOfThreads)
{
  Options options = Keeping(ErrorOfAnySize(0.5 * Spacing(this->Voxels)));
  const Result expected = this->Run(options);
  for (const int threads : { 2, 3 })
  {
    options.NumberOfThreads = threads;
    const Result result = this->Run(options);
    EXPECT_TRUE(SameBytes(result.Surface, expected.Surface));
    EXPECT_EQ(result.BoundaryLabels, expected.BoundaryLabels);
    EXPECT_EQ(result.Report.Voxels.Changes.Compared, expected.Report.Voxels.Changes.Compared);
  }
}

/// Without the guard, or with another map's grid, voxels change, and the check counts them as the
/// voxelizer of the tests does.
TEST_P(EachMap, ChangesVoxelsWithoutTheGuardAndTheCheckSeesThem)
{
  const Result result = this->Run(Free(Reduction(0.9)));
  const VoxelReport& voxels = result.Report.Voxels;
  EXPECT_FALSE(voxels.WereGuarded);
  EXPECT_GT(voxels.Changes.Changed, 0);
  EXPECT_GT(WrongVoxels(this->Voxels, this->Surfaces, result), 0);
  std::int64_t lost = 0;
  for (const LabelChanges& label : voxels.Changes.OfLabel)
  {
    lost += label.Lost;
  }
  EXPECT_EQ(lost, voxels.Changes.Changed) << "every voxel of the input has a label";
}

INSTANTIATE_TEST_SUITE_P(Voxels, EachMap, testing::ValuesIn(Maps()), NameOfMap);
INSTANTIATE_TEST_SUITE_P(
  Voxels, SomeMap, testing::Values(Maps().front(), Maps()[4], Maps().back()), NameOfMap);

namespace
{
class KeepVoxelsOption : public testing::Test
{
protected:
  LabelMap Voxels = NoisyBones(UnitGrid(Size), 0.5);
  LabelSurfaces Surfaces = Extracted(this->Voxels);

  Result Run(const Options& options) const
  {
    return Decimate(this->Surfaces.Surface, options, {}, With(this->Surfaces));
  }
};
}

TEST_F(KeepVoxelsOption, IsOnByDefaultUpToHalfAVoxelAndWithoutABound)
{
  EXPECT_TRUE(this->Run(Unmeasured()).Report.Voxels.WereGuarded);
  EXPECT_TRUE(this->Run(Error(0.5)).Report.Voxels.WereGuarded);
  EXPECT_FALSE(this->Run(Error(0.6)).Report.Voxels.WereGuarded);
  EXPECT_TRUE(this->Run(Keeping(Error(0.6))).Report.Voxels.WereGuarded);
  EXPECT_FALSE(this->Run(Free(Error(0.5))).Report.Voxels.WereGuarded);
}

TEST_F(KeepVoxelsOption, AloneRunsUntilNoEditIsPossible)
{
  const Result reduced = this->Run(Unmeasured());
  const Result alone = this->Run(Keeping(Unmeasured()));
  EXPECT_EQ(alone.Report.Stop, StopReason::NothingLeft);
  EXPECT_LE(alone.Surface.Triangles.size(), reduced.Surface.Triangles.size());
  EXPECT_GT(alone.Report.Edits.Rejections[static_cast<std::size_t>(Rejection::VoxelLabel)], 0);
}

TEST_F(KeepVoxelsOption, HoldsWhereWritingRoundsPositions)
{
  // 300 m from the origin, single precision has steps of a thirty-second of a voxel.
  LabelMap map = NoisyBones(UnitGrid(Size), 1.5);
  map.Grid.Origin = Vector3::Constant(3e5);
  const LabelSurfaces surfaces = Extracted(map);
  for (const Mode mode : { Mode::Fast, Mode::Balanced })
  {
    Options options = InMode(mode, Keeping(Unmeasured()));
    options.OutputPointsPrecision = PointsPrecision::Single;
    const Result result = Decimate(surfaces.Surface, options, {}, With(surfaces));
    EXPECT_LT(result.Surface.Triangles.size(), surfaces.Surface.Triangles.size());
    EXPECT_EQ(result.Report.Voxels.Changes.Changed, 0) << WordOf(mode);
    EXPECT_EQ(WrongVoxels(map, surfaces, result), 0) << WordOf(mode);
  }
}

TEST_F(KeepVoxelsOption, NeedsAGridIfItIsOn)
{
  const Result result = Decimate(this->Surfaces.Surface, Keeping(Unmeasured()));
  EXPECT_EQ(result.Report.Status, InputStatus::NoVoxelGrid);
  EXPECT_NE(InputMessage(result.Report).find("no voxel grid"), std::string::npos);
  EXPECT_EQ(Decimate(this->Surfaces.Surface, Unmeasured()).Report.Status, InputStatus::Good);
}

TEST_F(KeepVoxelsOption, RejectsGridsAndLabelsThatDoNotFit)
{
  const auto statusOf = [&](const auto& spoil)
  {
    LabelSurfaces spoiled = this->Surfaces;
    spoil(spoiled.Source);
    return Decimate(spoiled.Surface, Unmeasured(), {}, With(spoiled)).Report.Status;
  };
  using Source = LabelMapSource;
  EXPECT_EQ(statusOf([](Source& s) { s.Grid.Spacing[1] = 0.0; }), InputStatus::BadLabelMap);
  EXPECT_EQ(statusOf([](Source& s) { s.Grid.Spacing[1] = 1e-9; }), InputStatus::BadLabelMap);
  EXPECT_EQ(statusOf([](Source& s) { s.Grid.Origin[2] = std::nan(""); }), InputStatus::BadLabelMap);
  EXPECT_EQ(statusOf([](Source& s) { s.Grid.Direction(0, 1) = 0.1; }), InputStatus::BadLabelMap);
  EXPECT_EQ(statusOf([](Source& s) { s.OfTriangle.pop_back(); }), InputStatus::BadLabelMap);
  EXPECT_EQ(statusOf([](Source& s) { s.OfTriangle[3][0] = 99; }), InputStatus::BadLabelMap);
}

TEST_F(KeepVoxelsOption, KeepsTheLabelsOfEveryTriangleAndTheirWalls)
{
  const Result result = this->Run(Keeping(Unmeasured()));
  ASSERT_EQ(result.BoundaryLabels.size(), result.Surface.Triangles.size());
  const std::vector<BoundaryLabels>& before = this->Surfaces.Source.OfTriangle;
  const std::set<BoundaryLabels> pairsBefore(before.begin(), before.end());
  const std::set<BoundaryLabels> pairsAfter(
    result.BoundaryLabels.begin(), result.BoundaryLabels.end());
  EXPECT_EQ(pairsAfter, pairsBefore);
}

TEST_F(KeepVoxelsOption, HoldsWithTolerances)
{
  std::vector<double> tolerances(this->Surfaces.Surface.Points.size(), -1.0);
  for (std::size_t p = 0; p < tolerances.size(); ++p)
  {
    const double x = this->Surfaces.Surface.Points[p][0];
    tolerances[p] = x < 4.0 ? 0.0 : x < 9.0 ? 0.4 : -1.0;
  }
  RunInputs inputs = With(this->Surfaces);
  inputs.Tolerances = &tolerances;
  const Result result = Decimate(this->Surfaces.Surface, Keeping(Unmeasured()), {}, inputs);
  EXPECT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(result.Report.Voxels.Changes.Changed, 0);
  EXPECT_EQ(WrongVoxels(this->Voxels, this->Surfaces, result), 0);
}

TEST_F(KeepVoxelsOption, HoldsOnOpenSurfaces)
{
  LabelMap cut = this->Voxels;
  for (std::size_t i = 0; i < cut.Labels.size(); ++i)
  {
    const std::size_t x = i % static_cast<std::size_t>(Size[0]);
    cut.Labels[i] = x < 2 || x > 12 ? cut.Labels[i] + 1 : cut.Labels[i];
  }
  const LabelSurfaces open = Extracted(cut, false);
  ASSERT_TRUE(HasBoundary(open.Surface));
  const Result result = Decimate(open.Surface, Keeping(Unmeasured()), {}, With(open));
  EXPECT_LT(result.Surface.Triangles.size(), open.Surface.Triangles.size());
  EXPECT_EQ(result.Report.Voxels.Changes.Changed, 0);
  const VoxelChanges byMap = CompareVoxels(MakeLabelImage(cut.Labels.data(), cut.Grid),
    open.Source.Values, { result.Surface, result.BoundaryLabels },
    { {}, static_cast<Index>(open.Source.Values.size()), 1 });
  EXPECT_EQ(byMap.Changed, 0);
}

/// Every level of detail.
TEST_F(KeepVoxelsOption, HoldsInEveryLevelOfALog)
{
  EditLog log;
  RunInputs inputs = With(this->Surfaces);
  inputs.Log = &log;
  const Result result = Decimate(this->Surfaces.Surface, Keeping(Reduction(0.8)), {}, inputs);
  EXPECT_EQ(result.Report.Status, InputStatus::Good);
  EXPECT_EQ(result.Report.Voxels.Changes.Changed, 0);
}
