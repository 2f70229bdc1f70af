// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bones.h"

#include "Mesh/Cleaning.h"
#include "Specimen.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkExtractVOI.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageConstantPad.h"
#include "vtkImageData.h"
#include "vtkImageThreshold.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
constexpr double BoneHounsfield = 226.0;
constexpr double AirHounsfield = -1024.0;

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkImageData* volume, double value)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(volume);
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  return contour->GetOutput();
}

/// By the core's own cleaning; points keep their coordinates in single precision.
Triangles Cleaned(vtkPolyData* surface)
{
  bonedecimate::Surface raw;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    const double* x = surface->GetPoint(p);
    raw.Points.emplace_back(
      static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2]));
  }
  const auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    raw.Triangles.push_back({ static_cast<bonedecimate::Index>(ids[0]),
      static_cast<bonedecimate::Index>(ids[1]), static_cast<bonedecimate::Index>(ids[2]) });
  }
  const bonedecimate::CleanSurface clean = bonedecimate::Clean(raw, true);
  Triangles result;
  for (const bonedecimate::Index p : clean.InputPoint)
  {
    const bonedecimate::Vector3& x = raw.Points[static_cast<std::size_t>(p)];
    result.Points.push_back({ x[0], x[1], x[2] });
  }
  result.Corners.assign(clean.Surface.Triangles.begin(), clean.Surface.Triangles.end());
  return result;
}

vtkSmartPointer<vtkImageData> ReadVolume(const std::string& file)
{
  vtkNew<vtkMetaImageReader> reader;
  if (reader->CanReadFile(file.c_str()) == 0)
  {
    throw std::runtime_error(file + ": no MetaImage");
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

template <class Reader>
Triangles ReadWith(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  if (triangles->GetOutput()->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(file + ": no triangles in it");
  }
  return Cleaned(triangles->GetOutput());
}

Triangles SpecimenOnGrid(int size)
{
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(size) * size * size);
  FillSpecimen(size, values->GetPointer(0));
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(size, size, size);
  volume->SetSpacing(SpecimenSpacing, SpecimenSpacing, SpecimenSpacing);
  volume->GetPointData()->SetScalars(values);
  return Cleaned(SurfaceOf(volume, 0.0));
}
}

Triangles WholeBone(const std::string& volume)
{
  return Cleaned(SurfaceOf(ReadVolume(volume), BoneHounsfield));
}

Triangles LargestIn(const std::string& volume, const Box& box)
{
  const vtkSmartPointer<vtkImageData> image = ReadVolume(volume);
  const double* spacing = image->GetSpacing();
  const int* whole = image->GetExtent();
  std::array<int, 6> extent{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto voxel = [&](double millimeters)
    { return static_cast<int>(std::lround(millimeters / spacing[axis])); };
    extent[2 * axis] = std::max(whole[2 * axis], voxel(box[2 * axis]));
    extent[2 * axis + 1] = std::min(whole[2 * axis + 1], voxel(box[2 * axis + 1]) - 1);
  }
  vtkNew<vtkExtractVOI> cut;
  cut->SetInputData(image);
  cut->SetVOI(extent.data());
  vtkNew<vtkImageConstantPad> pad;
  pad->SetInputConnection(cut->GetOutputPort());
  pad->SetConstant(AirHounsfield);
  pad->SetOutputWholeExtent(
    extent[0] - 1, extent[1] + 1, extent[2] - 1, extent[3] + 1, extent[4] - 1, extent[5] + 1);
  pad->Update();
  vtkNew<vtkPolyDataConnectivityFilter> largest;
  largest->SetInputData(SurfaceOf(pad->GetOutput(), BoneHounsfield));
  largest->SetExtractionModeToLargestRegion();
  largest->Update();
  return Cleaned(largest->GetOutput());
}

Triangles BinaryCrop(const std::string& volume, const VoxelBox& box)
{
  vtkNew<vtkExtractVOI> cut;
  cut->SetInputData(ReadVolume(volume));
  cut->SetVOI(box[0], box[1] - 1, box[2], box[3] - 1, box[4], box[5] - 1);
  vtkNew<vtkImageThreshold> bone;
  bone->SetInputConnection(cut->GetOutputPort());
  bone->ThresholdByUpper(BoneHounsfield);
  bone->SetInValue(1.0);
  bone->SetOutValue(0.0);
  bone->SetOutputScalarTypeToFloat();
  bone->Update();
  return Cleaned(SurfaceOf(bone->GetOutput(), 0.5));
}

Triangles SurfaceFile(const std::string& file)
{
  const std::string ending = file.substr(std::min(file.size(), file.rfind('.')));
  if (ending == ".ply")
  {
    return ReadWith<vtkPLYReader>(file);
  }
  if (ending == ".stl")
  {
    return ReadWith<vtkSTLReader>(file);
  }
  if (ending == ".obj")
  {
    return ReadWith<vtkOBJReader>(file);
  }
  if (ending == ".vtp")
  {
    return ReadWith<vtkXMLPolyDataReader>(file);
  }
  if (ending == ".vtk")
  {
    return ReadWith<vtkPolyDataReader>(file);
  }
  throw std::runtime_error(file + ": not one of .ply .stl .obj .vtp .vtk");
}

Triangles GrownSpecimen(double triangles)
{
  // A small one says how many triangles a voxel has; their number grows with a power a little below
  // the cube.
  int size = 64;
  Triangles specimen = SpecimenOnGrid(size);
  for (int attempt = 0; attempt < 6; ++attempt)
  {
    const double ratio = triangles / static_cast<double>(specimen.Corners.size());
    if (std::fabs(ratio - 1.0) < 0.03)
    {
      break;
    }
    size = static_cast<int>(std::lround(size * std::pow(ratio, 1.0 / 2.9)));
    specimen = SpecimenOnGrid(size);
  }
  return specimen;
}
