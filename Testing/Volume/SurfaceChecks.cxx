// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChecks.h"

#include "Specimen.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace bonedecimate::testing
{
using volume::Cross;
using volume::Dot;

TemporaryFolder::TemporaryFolder()
  : Path((std::filesystem::path(::testing::TempDir()) / "bonedecimate-XXXXXX").string())
{
  EXPECT_NE(mkdtemp(this->Path.data()), nullptr);
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code error;
  std::filesystem::remove_all(this->Path, error);
}

std::string TemporaryFolder::File(const std::string& name) const
{
  return (std::filesystem::path(this->Path) / name).string();
}

double EnclosedVolume(vtkPolyData* surface)
{
  double volume = 0.0;
  Vector3 first;
  surface->GetPoint(0, first.data()); // near the surface, for the sake of digits
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    std::array<Vector3, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(ids->GetId(i), corners[i].data());
      std::transform(corners[i].begin(), corners[i].end(), first.begin(), corners[i].begin(),
        [](double a, double b) { return a - b; });
    }
    volume += Dot(Cross(corners[0], corners[1]), corners[2]) / 6.0;
  }
  return volume;
}

double LargestDeviation(vtkPolyData* surface)
{
  double largest = 0.0;
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    Vector3 p;
    surface->GetPoint(id, p.data());
    largest = std::max(largest, std::abs(SpecimenDistance(p)));
  }
  return largest;
}

int CountComponents(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataConnectivityFilter> connectivity;
  connectivity->SetInputData(surface);
  connectivity->SetExtractionModeToAllRegions();
  connectivity->Update();
  return connectivity->GetNumberOfExtractedRegions();
}

void ExpectSpecimen(const BoneSurface& bone)
{
  ASSERT_EQ(bone.Problem, "");
  ASSERT_NE(bone.Surface, nullptr);
  EXPECT_EQ(CountComponents(bone.Surface), 2);
  // A tenth of a voxel, for values between voxels are taken to run straight.
  EXPECT_LT(LargestDeviation(bone.Surface), 0.1);
  EXPECT_NEAR(EnclosedVolume(bone.Surface), SpecimenVolume(), 0.02 * SpecimenVolume());
}

void ExpectEqual(vtkPolyData* a, vtkPolyData* b, double tolerance)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfPolys(), b->GetNumberOfPolys());
  double largest = 0.0;
  for (vtkIdType id = 0; id < a->GetNumberOfPoints(); ++id)
  {
    for (int i = 0; i < 3; ++i)
    {
      largest = std::max(largest, std::abs(a->GetPoint(id)[i] - b->GetPoint(id)[i]));
    }
  }
  EXPECT_LE(largest, tolerance);
  vtkNew<vtkIdList> idsOfA;
  vtkNew<vtkIdList> idsOfB;
  for (vtkIdType cell = 0; cell < a->GetNumberOfPolys(); ++cell)
  {
    a->GetPolys()->GetCellAtId(cell, idsOfA);
    b->GetPolys()->GetCellAtId(cell, idsOfB);
    ASSERT_TRUE(std::equal(idsOfA->begin(), idsOfA->end(), idsOfB->begin(), idsOfB->end()));
  }
}

void ExpectRejection(const std::string& path, const std::string& words, double hounsfield)
{
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const BoneSurface bone = ExtractBoneSurface(path, hounsfield);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(bone.Surface, nullptr);
  EXPECT_NE(bone.Problem.find(words), std::string::npos)
    << path << " should say: " << words << "\nIt says: " << bone.Problem;
}
}
