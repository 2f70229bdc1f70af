// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bones.h"

#include "Mesh/Cleaning.h"

#include "vtkCellArray.h"
#include "vtkExtractVOI.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageConstantPad.h"
#include "vtkImageData.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double BoneHounsfield = 226.0;
constexpr double AirHounsfield = -1024.0;

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkImageData* volume)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(volume);
  contour->SetValue(0, BoneHounsfield);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// The core's own cleaning, so that every contestant starts from the same triangles.
vtkSmartPointer<vtkPolyData> Cleaned(vtkPolyData* surface)
{
  bonedecimate::Surface raw;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    raw.Points.emplace_back(
      surface->GetPoint(p)[0], surface->GetPoint(p)[1], surface->GetPoint(p)[2]);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    raw.Triangles.push_back({ static_cast<bonedecimate::Index>(ids->GetId(0)),
      static_cast<bonedecimate::Index>(ids->GetId(1)),
      static_cast<bonedecimate::Index>(ids->GetId(2)) });
  }
  const bonedecimate::CleanSurface clean = bonedecimate::Clean(raw, true);
  vtkNew<vtkPoints> points;
  for (const bonedecimate::Index p : clean.InputPoint)
  {
    points->InsertNextPoint(raw.Points[static_cast<std::size_t>(p)].data());
  }
  vtkNew<vtkCellArray> triangles;
  for (const bonedecimate::Triangle& corners : clean.Surface.Triangles)
  {
    triangles->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(triangles);
  return result;
}
}

Bones::Bones(const std::string& volumeFile)
  : VolumeFile(volumeFile)
{
}

vtkSmartPointer<vtkPolyData> Bones::Whole() const
{
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(this->VolumeFile.c_str());
  reader->Update();
  return Cleaned(SurfaceOf(reader->GetOutput()));
}

vtkSmartPointer<vtkPolyData> Bones::LargestIn(const Box& box) const
{
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(this->VolumeFile.c_str());
  reader->Update();
  const double* spacing = reader->GetOutput()->GetSpacing();
  const int* whole = reader->GetOutput()->GetExtent();
  std::array<int, 6> extent{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto voxel = [&](double millimetres)
    { return static_cast<int>(std::lround(millimetres / spacing[axis])); };
    extent[2 * axis] = std::max(whole[2 * axis], voxel(box[2 * axis]));
    extent[2 * axis + 1] = std::min(whole[2 * axis + 1], voxel(box[2 * axis + 1]) - 1);
  }
  vtkNew<vtkExtractVOI> cut;
  cut->SetInputConnection(reader->GetOutputPort());
  cut->SetVOI(extent.data());
  vtkNew<vtkImageConstantPad> pad;
  pad->SetInputConnection(cut->GetOutputPort());
  pad->SetConstant(AirHounsfield);
  pad->SetOutputWholeExtent(
    extent[0] - 1, extent[1] + 1, extent[2] - 1, extent[3] + 1, extent[4] - 1, extent[5] + 1);
  pad->Update();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputData(SurfaceOf(pad->GetOutput()));
  largest->SetExtractionModeToLargestRegion();
  largest->Update();
  return Cleaned(largest->GetOutput());
}
