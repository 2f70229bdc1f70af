// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomSeries.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace bonedecimate::volume
{
namespace
{
using Slices = std::vector<DicomSlice>;

/// A localizer often stands in the series it was made for: same identifier, another plane.
bool BelongTogether(const DicomSlice& a, const DicomSlice& b)
{
  return a.Series == b.Series && a.Rows == b.Rows && a.Columns == b.Columns &&
    AreClose(a.AlongRow, b.AlongRow) && AreClose(a.AlongColumn, b.AlongColumn) &&
    std::abs(a.RowDistance - b.RowDistance) < 1e-3 &&
    std::abs(a.ColumnDistance - b.ColumnDistance) < 1e-3;
}

std::vector<Slices> Grouped(const Slices& slices)
{
  std::vector<Slices> groups;
  for (const DicomSlice& slice : slices)
  {
    const auto found = std::find_if(groups.begin(), groups.end(),
      [&slice](const Slices& group) { return BelongTogether(group.front(), slice); });
    if (found == groups.end())
    {
      groups.push_back({ slice });
    }
    else
    {
      found->push_back(slice);
    }
  }
  return groups;
}

/// Copies of one image count once. Returns how many were left out.
std::size_t RemoveCopies(Slices& slices)
{
  std::set<std::string> seen;
  const auto isCopy = [&seen](const DicomSlice& slice)
  { return !slice.Instance.empty() && !seen.insert(slice.Instance).second; };
  const std::size_t before = slices.size();
  slices.erase(std::remove_if(slices.begin(), slices.end(), isCopy), slices.end());
  return before - slices.size();
}

void SortByPosition(Slices& slices)
{
  const Vector3 normal = Cross(slices.front().AlongRow, slices.front().AlongColumn);
  std::stable_sort(slices.begin(), slices.end(),
    [&normal](const DicomSlice& a, const DicomSlice& b)
    { return Dot(a.Position, normal) < Dot(b.Position, normal); });
}

VolumeGeometry SeriesGeometry(const Slices& slices)
{
  const DicomSlice& first = slices.front();
  const Vector3 way = Difference(slices.back().Position, first.Position);
  VolumeGeometry geometry;
  geometry.Origin = first.Position;
  geometry.Steps[0] = Scaled(first.AlongRow, first.ColumnDistance);
  geometry.Steps[1] = Scaled(first.AlongColumn, first.RowDistance);
  geometry.Steps[2] = Scaled(way, 1.0 / static_cast<double>(slices.size() - 1));
  return geometry;
}

/// Positions are often rounded to a tenth of a millimeter; a slice that is missing is off by far
/// more.
std::string EvennessProblem(const Slices& slices, const VolumeGeometry& geometry)
{
  const double tolerance = 0.2 * Length(geometry.Steps[2]);
  for (std::size_t k = 0; k < slices.size(); ++k)
  {
    const Vector3 expected =
      Sum(geometry.Origin, Scaled(geometry.Steps[2], static_cast<double>(k)));
    if (!(Length(Difference(slices[k].Position, expected)) <= tolerance))
    {
      return "its slices are not evenly spaced: slice " + std::to_string(k + 1) + " of " +
        std::to_string(slices.size()) + " is out of line, one is missing or there twice";
    }
  }
  return std::string();
}

std::string SeriesProblem(const DicomSeries& series)
{
  const auto hasFrames = [](const DicomSlice& slice) { return slice.Frames > 1; };
  if (std::any_of(series.Slices.begin(), series.Slices.end(), hasFrames))
  {
    return "it holds files of several frames; save them as one file a slice";
  }
  const std::string problem = GeometryProblem(series.Geometry);
  return problem.empty() ? EvennessProblem(series.Slices, series.Geometry) : problem;
}
}

DicomSeries LargestSeries(const Slices& slices)
{
  DicomSeries series;
  std::vector<Slices> groups = Grouped(slices);
  if (groups.empty())
  {
    series.Problem = "none of its DICOM files is an image with a position in the patient";
    return series;
  }
  const auto rank = [](const Slices& group)
  { return std::make_pair(group.front().IsTomography, group.size()); };
  const auto largest = std::max_element(groups.begin(), groups.end(),
    [&rank](const Slices& a, const Slices& b) { return rank(a) < rank(b); });
  series.Slices = std::move(*largest);
  const std::size_t copies = RemoveCopies(series.Slices);
  if (groups.size() > 1)
  {
    series.Note = "Of " + std::to_string(groups.size()) + " series the one with " +
      std::to_string(series.Slices.size()) + " slices was taken.";
  }
  if (copies > 0)
  {
    series.Note += (series.Note.empty() ? "" : " ") + std::to_string(copies) +
      " files are copies of others and were left aside.";
  }
  if (series.Slices.size() < 2)
  {
    series.Problem = "its largest series has one slice, a surface needs at least two";
    return series;
  }
  SortByPosition(series.Slices);
  series.Geometry = SeriesGeometry(series.Slices);
  series.Problem = SeriesProblem(series);
  return series;
}
}
