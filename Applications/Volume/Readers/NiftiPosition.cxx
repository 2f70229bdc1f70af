// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NiftiPosition.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <locale>
#include <sstream>

namespace bonedecimate::volume
{
namespace
{
bool HasSform(const NiftiHeader& header)
{
  return header.At<std::int16_t>(254) > 0;
}

bool HasQform(const NiftiHeader& header)
{
  return header.At<std::int16_t>(252) > 0;
}

/// mm
VolumeGeometry SformOf(const NiftiHeader& header)
{
  VolumeGeometry geometry;
  for (std::size_t row = 0; row < 3; ++row)
  {
    const double sign = row < 2 ? -1.0 : 1.0; // RAS to LPS
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      geometry.Steps[axis][row] = sign * double(header.At<float>(280 + 16 * row + 4 * axis));
    }
    geometry.Origin[row] = sign * double(header.At<float>(292 + 16 * row));
  }
  return InMillimeters(geometry, header.Unit());
}

/// The rule of ITK, except that ITK takes the qform if the sform is sheared, as by a tilted gantry.
bool IsBySform(const NiftiHeader& header)
{
  const bool isOfScanner = header.At<std::int16_t>(254) == 1;
  return HasSform(header) && (isOfScanner || !HasQform(header));
}

/// Error message if the position is by the sform, but the spacing is another one; empty if not.
std::string SpacingProblem(const NiftiHeader& header)
{
  const VolumeGeometry geometry = SformOf(header);
  for (std::size_t axis = 0; IsBySform(header) && axis < 3; ++axis)
  {
    const double spacing = header.Unit().Millimeters * double(header.At<float>(80 + 4 * axis));
    if (!(std::abs(Length(geometry.Steps[axis]) - spacing) <= 1e-3 * spacing))
    {
      return "its spacing is not that of its sform; save it with the same in both";
    }
  }
  return std::string();
}

/// ITK converts the spacing; the offsets since 5.3.
Vector3 OffsetOf(const NiftiHeader& header)
{
  const double unit = header.Unit().Millimeters;
  return { { -unit * double(header.At<float>(268)), -unit * double(header.At<float>(272)),
    unit * double(header.At<float>(276)) } };
}

/// The largest coordinate of the difference of the positions of a voxel, mm.
double Distance(
  const VolumeGeometry& a, const VolumeGeometry& b, const std::array<std::int64_t, 3>& size)
{
  double largest = 0.0;
  for (std::size_t row = 0; row < 3; ++row)
  {
    double lowest = a.Origin[row] - b.Origin[row];
    double highest = lowest;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double along =
        static_cast<double>(size[axis] - 1) * (a.Steps[axis][row] - b.Steps[axis][row]);
      lowest += std::min(along, 0.0);
      highest += std::max(along, 0.0);
    }
    largest = std::max({ largest, std::abs(lowest), std::abs(highest) });
  }
  return largest;
}

}

std::string PositionProblem(const NiftiHeader& header, const ItkHeader& read)
{
  const bool isBySform = IsBySform(header);
  const std::string spacing = SpacingProblem(header);
  return !spacing.empty() ? spacing
    : isBySform           ? GeometryProblem(SformOf(header))
    : !read.HasGeometry   ? "its header has no position"
                          : std::string();
}

VolumeGeometry PositionOf(const NiftiHeader& header, const ItkHeader& read)
{
  if (IsBySform(header))
  {
    return SformOf(header);
  }
  VolumeGeometry geometry = read.Geometry;
  geometry.Origin = HasQform(header) ? OffsetOf(header) : Vector3{};
  return geometry;
}

std::string PositionNote(const NiftiHeader& header, const VolumeGeometry& position,
  const std::array<std::int64_t, 3>& size)
{
  if (!HasSform(header) && !HasQform(header))
  {
    return "its header does not say how the patient lies (sform_code and qform_code are 0): x is "
           "taken to run to the "
           "left and y to the back, as ITK does; nibabel and FSL let y run to the front, so the "
           "surface may be mirrored";
  }
  const auto& steps = position.Steps;
  const double spacing = std::min({ Length(steps[0]), Length(steps[1]), Length(steps[2]) });
  const double distance = HasSform(header) ? Distance(position, SformOf(header), size) : 0.0;
  if (distance <= 0.1 * spacing)
  {
    return std::string();
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "its sform and qform are up to " << distance
       << " mm apart; positions are those of its qform";
  return text.str();
}
}
