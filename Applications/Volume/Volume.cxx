// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volume.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bonedecimate::volume
{
namespace
{
/// What zlib can make of one byte at best; no other compression of images gets near on real voxels.
constexpr double LargestExpansion = 1032.0;

std::string SizeText(const std::array<std::int64_t, 3>& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]) + " voxels";
}
}

Volume RejectedVolume(const std::string& problem)
{
  Volume volume;
  volume.Problem = problem;
  return volume;
}

Vector3 Sum(const Vector3& a, const Vector3& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

Vector3 Difference(const Vector3& a, const Vector3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

Vector3 Scaled(const Vector3& a, double factor)
{
  return { { a[0] * factor, a[1] * factor, a[2] * factor } };
}

double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

double Length(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}

bool AreClose(const Vector3& a, const Vector3& b)
{
  return Length(Difference(a, b)) < 1e-3;
}

double LeastDistance(const LayerPositions& layers)
{
  double least = layers.empty() ? 1.0 : std::numeric_limits<double>::max();
  for (std::size_t k = 1; k < layers.size(); ++k)
  {
    least = std::min(least, layers[k] - layers[k - 1]);
  }
  return least;
}

double Determinant(const VolumeGeometry& geometry)
{
  return Dot(Cross(geometry.Steps[0], geometry.Steps[1]), geometry.Steps[2]);
}

std::string GeometryProblem(const VolumeGeometry& geometry)
{
  double box = 1.0;
  for (const Vector3& step : geometry.Steps)
  {
    box *= Length(step);
  }
  if (!std::isfinite(box) || !std::isfinite(Length(geometry.Origin)))
  {
    return "its origin, spacing or direction is not a finite number";
  }
  // Below a thousandth of the box the three directions are one plane but for rounding.
  if (!(std::abs(Determinant(geometry)) > 1e-3 * box))
  {
    return "its spacing is zero or its directions lie in one plane";
  }
  return std::string();
}

std::string SizeProblem(const std::array<std::int64_t, 3>& size, int bytesPerVoxel,
  std::uintmax_t bytesInFile, bool isCompressed)
{
  double bytes = bytesPerVoxel;
  for (const std::int64_t extent : size)
  {
    if (extent < 2 || extent > std::numeric_limits<int>::max())
    {
      return "it announces " + SizeText(size) + ", a surface needs at least two along each axis";
    }
    bytes *= static_cast<double>(extent);
  }
  const double available =
    static_cast<double>(bytesInFile) * (isCompressed ? LargestExpansion : 1.0);
  if (bytes > available)
  {
    return "it is truncated: it announces " + SizeText(size) + ", which its " +
      std::to_string(bytesInFile) + " bytes of data cannot hold";
  }
  return std::string();
}

vtkSmartPointer<vtkImageData> AllocateImage(
  const std::array<std::int64_t, 3>& size, int scalarType, int components)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(
    static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]));
  image->AllocateScalars(scalarType, components);
  return image;
}
}
