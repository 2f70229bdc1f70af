// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomSeries.h"

#include "FilePath.h"
#include "SpacingRuns.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace bonedecimate::volume
{
namespace
{
using Slices = DicomSlices;

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

std::string NameOf(const DicomSlice& slice)
{
  return FilePath(slice.File).filename().string() +
    (slice.FramesInFile > 1 ? ", frame " + std::to_string(slice.Frame + 1) : std::string());
}

/// From each slice to the next one, along the line from the first to the last, mm.
std::vector<double> DistancesOf(const Slices& slices, const Vector3& direction)
{
  std::vector<double> distances;
  for (std::size_t k = 1; k < slices.size(); ++k)
  {
    distances.push_back(Dot(Difference(slices[k].Position, slices[k - 1].Position), direction));
  }
  return distances;
}

double MedianOf(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Whether slices are beside the line from the first to the last, or two at one position.
std::string LineProblem(const Slices& slices, const Vector3& direction, double usual)
{
  const std::vector<double> distances = DistancesOf(slices, direction);
  for (std::size_t k = 1; k < slices.size(); ++k)
  {
    const Vector3 way = Difference(slices[k].Position, slices.front().Position);
    const Vector3 aside = Difference(way, Scaled(direction, Dot(way, direction)));
    if (!(Length(aside) <= 0.2 * usual))
    {
      return "its slice " + NameOf(slices[k]) + " lies " + LengthText(Length(aside)) +
        " beside the line of the others";
    }
    if (!(distances[k - 1] > 0.02 * usual))
    {
      return "its slices " + NameOf(slices[k - 1]) + " and " + NameOf(slices[k]) +
        " lie at the same position; remove one of them";
    }
  }
  return std::string();
}

/// Positions are often rounded to a tenth of a millimeter; a slice that is missing is off by far
/// more.
bool AreEven(const Slices& slices, const VolumeGeometry& geometry)
{
  const double tolerance = 0.2 * Length(geometry.Steps[2]);
  for (std::size_t k = 0; k < slices.size(); ++k)
  {
    const Vector3 expected =
      Sum(geometry.Origin, Scaled(geometry.Steps[2], static_cast<double>(k)));
    if (!(Length(Difference(slices[k].Position, expected)) <= tolerance))
    {
      return false;
    }
  }
  return true;
}

/// Names the slices on both sides of the first distance that differs from the usual one.
std::string GapProblem(const Slices& slices, const std::vector<double>& distances)
{
  const double usual = MedianOf(distances);
  const auto isOther = [usual](double distance) { return IsOtherDistance(distance, usual); };
  const auto other = std::find_if(distances.begin(), distances.end(), isOther);
  if (other == distances.end())
  {
    return "its slices are not evenly spaced";
  }
  const auto k = static_cast<std::size_t>(other - distances.begin());
  return "its slices are not evenly spaced: " + LengthText(*other) + " instead of " +
    LengthText(usual) + " between " + NameOf(slices[k]) + " and " + NameOf(slices[k + 1]) +
    ", slices " + std::to_string(k + 1) + " and " + std::to_string(k + 2) + " of " +
    std::to_string(slices.size()) +
    (*other > usual ? "; one or more between them are missing"
                    : "; give a folder without those that do not belong to it");
}

std::string RunsNote(const Slices& slices, const std::vector<SpacingRun>& runs)
{
  std::string note = "Its slices are " + LengthText(runs.front().Distance) + " apart";
  for (std::size_t i = 1; i < runs.size(); ++i)
  {
    note += (i > 1 ? ", " : " and ") + LengthText(runs[i].Distance) + " from " +
      NameOf(slices[runs[i].First]) + " on";
  }
  return note + "; they are read where they are.";
}

/// Sets the layers of slices that are not evenly spaced, or the problem if that is an error.
void TakeUnevenSlices(DicomSeries& series)
{
  const double step = Length(series.Geometry.Steps[2]);
  const Vector3 direction = Scaled(series.Geometry.Steps[2], 1.0 / step);
  const std::vector<double> distances = DistancesOf(series.Slices, direction);
  series.Problem = LineProblem(series.Slices, direction, MedianOf(distances));
  if (!series.Problem.empty())
  {
    return;
  }
  const std::vector<SpacingRun> runs = RunsOf(distances);
  if (!AreOnPurpose(runs))
  {
    series.Problem = GapProblem(series.Slices, distances);
    return;
  }
  series.Layers = { 0.0 };
  for (const double distance : distances)
  {
    series.Layers.push_back(series.Layers.back() + distance / step);
  }
  series.Note += (series.Note.empty() ? "" : " ") + RunsNote(series.Slices, runs);
}

std::string SeriesProblem(const DicomSeries& series)
{
  const auto hasFrames = [](const DicomSlice& slice) { return slice.Frames > 1; };
  if (std::any_of(series.Slices.begin(), series.Slices.end(), hasFrames))
  {
    return "it holds files of several frames that do not say where each lies; save them as one "
           "file a slice";
  }
  return GeometryProblem(series.Geometry);
}

/// Text with the subfolder of the slices; empty if they are in the folder itself.
std::string SubfolderOf(const Slices& slices, const std::string& folder)
{
  const std::string subfolder = FilePath(slices.front().File)
                                  .lexically_relative(FilePath(folder))
                                  .parent_path()
                                  .generic_string();
  return subfolder.empty() ? subfolder : " in " + subfolder;
}

/// Lists the series that were not taken, with their numbers.
std::string OthersText(
  const std::vector<Slices>& groups, std::size_t taken, const std::string& folder)
{
  constexpr std::size_t most = 5;
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    if (i != taken && ++count <= most)
    {
      text += (count > 1 ? ", " : "") + std::to_string(i + 1) + ": " + GroupText(groups[i], folder);
    }
  }
  return count > most ? text + " and " + std::to_string(count - most) + " more" : text;
}

/// Says which series was taken if there are several, or if it is in a subfolder.
std::string TakenNote(const std::vector<Slices>& groups, std::size_t taken,
  const DicomSeries& series, const std::string& folder)
{
  const std::string where = SubfolderOf(series.Slices, folder);
  if (groups.size() > 1)
  {
    return "Of " + std::to_string(groups.size()) + " series the one with " +
      std::to_string(series.Slices.size()) + " slices was taken" + where +
      "; others, for --series: " + OthersText(groups, taken, folder) + ".";
  }
  return where.empty() ? where : "The series" + where + " was taken.";
}
}

std::vector<Slices> GroupSeries(const Slices& slices)
{
  std::vector<Slices> groups = Grouped(slices);
  const auto rank = [](const Slices& group)
  { return std::make_pair(group.front().IsTomography, group.size()); };
  std::stable_sort(groups.begin(), groups.end(),
    [&rank](const Slices& a, const Slices& b) { return rank(b) < rank(a); });
  return groups;
}

std::string GroupText(const Slices& group, const std::string& folder)
{
  return std::to_string(group.size()) + (group.size() == 1 ? " slice" : " slices") +
    SubfolderOf(group, folder) + " from " + NameOf(group.front()) + " on";
}

DicomSeries TakeSeries(
  const std::vector<Slices>& groups, std::size_t index, bool isRequested, const std::string& folder)
{
  DicomSeries series;
  if (groups.empty())
  {
    series.Problem = "none of its DICOM files is an image with a position in the patient, as those "
                     "of a CT or MR are";
    return series;
  }
  series.Slices = groups[index];
  const std::size_t copies = RemoveCopies(series.Slices);
  if (isRequested)
  {
    series.Remark = "series " + std::to_string(index + 1) + " of " + std::to_string(groups.size()) +
      " is taken, as --series says: " + GroupText(groups[index], folder);
  }
  else
  {
    series.Note = TakenNote(groups, index, series, folder);
  }
  if (copies > 0)
  {
    series.Note += (series.Note.empty() ? "" : " ") + std::to_string(copies) +
      " files are copies of others and were left aside.";
  }
  if (series.Slices.size() < 2)
  {
    series.Problem = std::string(isRequested ? "that" : "its largest") +
      " series has one slice, a surface needs at least two";
    return series;
  }
  SortByPosition(series.Slices);
  series.Geometry = SeriesGeometry(series.Slices);
  series.Problem = SeriesProblem(series);
  if (series.Problem.empty() && !AreEven(series.Slices, series.Geometry))
  {
    TakeUnevenSlices(series);
  }
  return series;
}
}
