// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SizeText.h"

#include "Mesh/BoneSize.h"
#include "Options/NumberRange.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace bonedecimate
{
namespace
{
std::string Millimeters(double length)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.6g mm", length);
  return text;
}

/// mm, of the bounding box of the points that triangles use.
double UsedDiagonal(const Surface& surface)
{
  Vector3 least = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 most = -least;
  for (const Triangle& triangle : surface.Triangles)
  {
    for (const Index corner : triangle)
    {
      if (corner >= 0 && static_cast<std::size_t>(corner) < surface.Points.size())
      {
        least = least.cwiseMin(surface.Points[static_cast<std::size_t>(corner)]);
        most = most.cwiseMax(surface.Points[static_cast<std::size_t>(corner)]);
      }
    }
  }
  return least[0] <= most[0] ? (most - least).norm() : 0.0;
}

/// "the largest error of 50 mm"
std::string ErrorText(const SizeFigures& size)
{
  const std::string number = SentenceNumber(size.MaxError);
  return size.Point < 0
    ? "the largest error of " + number + " mm"
    : "the tolerance of " + number + " mm of point " + std::to_string(size.Point);
}
}

std::string SizeMessage(const SizeFigures& size, InputStatus status)
{
  const std::string diagonal =
    " of the diagonal of the input's bounding box, " + Millimeters(size.Diagonal);
  return status == InputStatus::ErrorBeyondSize
    ? ErrorText(size) + " is more than a quarter" + diagonal +
      "; the coordinates may not be in millimeters (AllowLargeError runs anyway)"
    : ErrorText(size) + " is less than a millionth" + diagonal + "; rounding alone exceeds it";
}

//------------------------------------------------------------------------------
std::vector<std::string> SizeWarnings(const SizeFigures& size)
{
  std::vector<std::string> warnings;
  if (size.Diagonal > 0.0 && !IsBoneSize(size.Diagonal))
  {
    warnings.push_back("the diagonal of the input's bounding box is " + Millimeters(size.Diagonal) +
      ", which is not the size of a bone; the coordinates may not be in millimeters");
  }
  if (size.ErrorBound < size.MaxError)
  {
    warnings.push_back(ErrorText(size) +
      " is more than the diagonal of the input's bounding box; " + Millimeters(size.ErrorBound) +
      " was used");
  }
  return warnings;
}

//------------------------------------------------------------------------------
std::vector<std::string> PairSizeWarnings(
  const Surface& reference, const Surface& result, double tolerance)
{
  const double before = UsedDiagonal(reference);
  const double after = UsedDiagonal(result);
  std::vector<std::string> warnings;
  const std::string units = "; the coordinates may not be in millimeters";
  if (before > 0.0 && tolerance > LargestErrorRatio * before)
  {
    warnings.push_back("the tolerance of " + SentenceNumber(tolerance) +
      " mm is more than a quarter of the diagonal of the reference's bounding box, " +
      Millimeters(before) + units);
  }
  else if (before > 0.0 && !IsBoneSize(before))
  {
    warnings.push_back("the diagonal of the reference's bounding box is " + Millimeters(before) +
      ", which is not the size of a bone" + units);
  }
  constexpr double most = 9.0;
  if (before > 0.0 && after > 0.0 && std::max(before / after, after / before) >= most)
  {
    char text[120];
    std::snprintf(text, sizeof(text),
      "the diagonal of the result is %.3g times that of the reference: the surfaces may have "
      "different units",
      after / before);
    warnings.emplace_back(text);
  }
  return warnings;
}
}
