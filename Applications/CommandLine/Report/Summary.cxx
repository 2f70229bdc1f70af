// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Summary.h"

#include "CountText.h"
#include "Figures/BoundText.h"
#include "InputSummary.h"
#include "NumberText.h"
#include "PartSection.h"
#include "PlainText.h"
#include "ProofSection.h"
#include "ReportFields.h"
#include "VoxelSection.h"

#include <algorithm>
#include <iostream>

namespace bonedecimate
{
namespace
{
void PrintTriangles(const ReportFields& report)
{
  std::cout << "triangles       "
            << GroupedText(CountBeforePruning(report, "triangles").value_or(0.0)) << " -> "
            << CountText(report, "output.triangles") << "\n";
}

void PrintComponents(const ReportFields& report)
{
  const bool wasPruned = report.Number("pruned.components").value_or(0.0) > 0.0;
  std::cout << "components      " << CountText(report, "output.components") << " of "
            << GroupedText(CountBeforePruning(report, "components").value_or(0.0)) << " kept"
            << (wasPruned ? ", " + CountText(report, "pruned.components") + " pruned on request"
                          : "")
            << "\n";
}

/// Labels touch, so the components of a surface with labels say little.
void PrintLabelsOrComponents(const ReportFields& report, const std::vector<SegmentRecord>& segments)
{
  if (segments.empty())
  {
    PrintComponents(report);
    return;
  }
  const auto kept = std::count_if(segments.begin(), segments.end(),
    [](const SegmentRecord& segment) { return segment.Triangles > 0; });
  std::cout << "labels          " << kept << " of " << segments.size() << " in the input kept\n";
}

void PrintDistances(
  const ReportFields& report, const std::string& direction, const std::string& words)
{
  const std::string path = "distance." + direction;
  const std::optional<double> maximum = report.Number(path + ".max");
  if (maximum)
  {
    std::cout << words << "max " << MeasuredText(*maximum) << ", mean "
              << MeasuredText(report.Number(path + ".mean").value_or(0.0)) << ", RMS "
              << MeasuredText(report.Number(path + ".rms").value_or(0.0)) << " mm\n";
  }
}

void PrintBoundaries(const ReportFields& report)
{
  const std::optional<double> there = report.Number("distance.boundary_input_to_output.upper");
  const std::optional<double> back = report.Number("distance.boundary_output_to_input.upper");
  if (there && back)
  {
    std::cout << "open boundaries within " << BoundText(std::max(*there, *back))
              << " mm of each other, curve to curve\n";
  }
}

void PrintVoxel(const ReportFields& report)
{
  const std::optional<double> size = report.Number("voxel.size");
  if (size)
  {
    const std::string from = report.Text("voxel.from");
    const double error = report.Number("voxel.error").value_or(0.0);
    std::cout << "voxel           " << FixedText(*size, 4) << " mm"
              << (from == "given"     ? ""
                     : from == "grid" ? ", estimated from the grid of the surface"
                                      : ", estimated from edges, +- " + FixedText(error, 2) + " mm")
              << "; at most " << FixedText(report.Number("voxel.largest_error").value_or(0.0), 4)
              << " mm requested\n";
  }
}

void PrintSmoothing(const ReportFields& report)
{
  constexpr double remaining = 0.95; // of the mean angle
  const auto value = [&report](const char* name)
  { return report.Number(std::string("smoothing.") + name).value_or(0.0); };
  if (!report.Number("smoothing.largest_displacement"))
  {
    return;
  }
  std::cout << "smoothed        by up to " << MillimeterText(value("largest_displacement"))
            << ", RMS " << MillimeterText(value("rms_displacement"))
            << " mm; mean angle between neighbors " << FixedText(value("angle_before"), 1) << " -> "
            << FixedText(value("angle_after"), 1) << " degrees"
            << (value("sharp_points") > 0.0
                   ? "; " + CountText(report, "smoothing.sharp_points") + " points on sharp edges"
                   : "");
  if (report.Number("voxels.compared") && value("angle_after") > remaining * value("angle_before"))
  {
    std::cout << "; its limit of " << MillimeterText(value("bound"))
              << " mm is too small for the steps of the voxels";
  }
  std::cout << "\n";
}

/// Area, volume and thickness of the largest.
void PrintParts(const ReportFields& report)
{
  constexpr int mostPrinted = 5;
  if (!report.Number("parts.count"))
  {
    return;
  }
  std::cout << "parts           " << CountText(report, "parts.count") << " "
            << report.Text("parts.kind") << ", before -> after, the largest first\n";
  for (int i = 0; i < mostPrinted; ++i)
  {
    if (!report.Number("parts.list." + std::to_string(i) + ".triangles"))
    {
      return;
    }
    const auto change = [&](const char* words, const char* figure, const char* unit)
    {
      const std::string text = PartChange(report, i, figure, " -> ");
      return text.empty() ? text : words + text + unit;
    };
    std::cout << "  " << PartName(report, i) << change(": area ", "area", " mm2")
              << change(", volume ", "volume", " mm3")
              << change(", thickness ", "thickness_median", " mm")
              << change(", 5 % below ", "thickness_percentile_5", " mm") << "\n";
  }
}

void PrintVoxels(const ReportFields& report)
{
  if (report.Number("voxels.changed"))
  {
    std::cout << "voxels          " << CountText(report, "voxels.changed") << " of "
              << CountText(report, "voxels.compared") << " have another label"
              << (report.Text("voxels.guard") == "on" ? "; edits may not change any" : "");
    const std::optional<double> bound = BoundInVoxels(report);
    std::cout << (bound ? "; the largest error is " + ShortText(*bound) + " voxels" : "") << "\n";
  }
}

/// Only if the map of a network was extracted.
void PrintModelGrid(const ReportSubject& subject)
{
  if (subject.ModelGrid)
  {
    std::cout << "model grid      " << ModelGridText(*subject.ModelGrid) << "\n";
  }
}

void PrintSlabs(const ReportSubject& subject)
{
  if (subject.Slabs)
  {
    const std::int64_t unproved = subject.Slabs->UnprovedSlabs;
    std::cout << "slabs           " << subject.Slabs->Slabs << " of up to "
              << GroupedText(static_cast<double>(subject.Slabs->MaxSlab)) << " triangles"
              << (unproved > 0
                     ? "; " + std::to_string(unproved) + " stay as they were, without a proof"
                     : std::string())
              << "\n";
  }
}

/// The segments of a label map, with the files that they have.
void PrintSegments(const std::vector<SegmentRecord>& segments)
{
  for (const SegmentRecord& segment : segments)
  {
    constexpr std::size_t mostPrinted = 3;
    const std::string changes = segment.Changed ? ChangesText(*segment.Changed) : std::string();
    std::cout << "segment         " << LabelText(segment.Label) << ": "
              << GroupedText(static_cast<double>(segment.Triangles)) << " triangles, "
              << segment.Volumes.size()
              << (segment.Volumes.size() == 1 ? " component" : " components");
    for (std::size_t i = 0; i < std::min(segment.Volumes.size(), mostPrinted); ++i)
    {
      std::cout << (i == 0 ? " of " : ", ") << SizeText(segment.Volumes[i]);
    }
    std::cout << (segment.Volumes.size() > mostPrinted ? ", ..." : "")
              << (segment.Volumes.empty() ? "" : " mm3")
              << (segment.File.empty() ? "" : ", " + segment.File)
              << (changes.empty() ? "" : "; " + changes) << "\n";
  }
  if (segments.size() > 1)
  {
    std::cout << "  a wall between two segments counts for both of them\n";
  }
}

/// Only with a least angle.
void PrintAngles(const ReportFields& report)
{
  if (report.Number("angles.below_minimum"))
  {
    std::cout << "angles          from "
              << GroupedText(report.Number("output.shape.smallest_angle").value_or(0.0), 1)
              << " degrees; " << CountText(report, "angles.below_minimum")
              << " triangles have a smaller one than requested\n";
  }
}

/// Only with an edge length.
void PrintEdges(const ReportFields& report)
{
  if (const std::optional<double> mean = report.Number("edges.mean_length"))
  {
    std::cout << "edges           " << GroupedText(*mean, 3) << " mm long on average, "
              << GroupedText(report.Number("edges.longest").value_or(0.0), 3) << " at most; "
              << CountText(report, "edges.longer") << " longer than 4/3 of the requested length, "
              << CountText(report, "edges.shorter") << " shorter than 4/5\n";
  }
}

/// With all that it does not cover.
void PrintProof(const ReportFields& report)
{
  std::cout << "proved          "
            << (report.Number("proof.upper") ? PlainText(report.Text("proof.sentence"))
                                             : "nothing: " + ReasonWithoutProof(report))
            << "\n";
}

void PrintCoordinates(const ReportSubject& subject)
{
  if (!subject.CoordinateSystem.empty())
  {
    std::cout << "coordinates     " << subject.CoordinateSystem
              << (subject.CoordinateSystem == "RAS"
                     ? " (x to the right, y to the front, z to the head)"
                     : " (x to the left, y to the back, z to the head)")
              << ", " << subject.Unit << "\n";
  }
}
}

std::string ModelGridText(const ModelGridRecord& model)
{
  const auto count = [](std::int64_t number) { return GroupedText(static_cast<double>(number)); };
  return model.Sentence + ", " + count(model.OfFile.Changed) + " of " +
    count(model.OfFile.Compared) +
    " voxels of the file have another label; the surface of these voxels is at most " +
    UpperBoundText(model.OfFile.Distance, 2) + " mm away";
}

void PrintShortSummary(vtkPolyData* result)
{
  const ReportFields report(result);
  PrintTriangles(report);
  PrintComponents(report);
  PrintProof(report);
}

void PrintSummary(
  vtkPolyData* result, const ReportSubject& subject, const std::vector<std::string>& written)
{
  const ReportFields report(result);
  const auto seconds = [&report](const char* name)
  { return GroupedText(report.Number(name).value_or(0.0), 2); };
  PrintTriangles(report);
  PrintLabelsOrComponents(report, subject.Segments);
  PrintInputSummary(report, subject.Specks);
  PrintSmoothing(report);
  if (report.Number("reference.triangles"))
  {
    std::cout << "reference       " << CountText(report, "reference.triangles")
              << " triangles: what distances are measured to\n";
  }
  PrintDistances(report, "output_to_input", "result to input ");
  PrintDistances(report, "input_to_output", "input to result ");
  PrintBoundaries(report);
  PrintVoxel(report);
  PrintSlabs(subject);
  PrintSegments(subject.Segments);
  if (subject.Segments.empty() && !subject.Changed.empty())
  {
    const std::string changes = ChangesText(subject.Changed.begin()->second);
    std::cout << "volume          " << (changes.empty() ? "no cavity filled" : changes) << "\n";
  }
  PrintParts(report);
  PrintVoxels(report);
  PrintModelGrid(subject);
  PrintAngles(report);
  PrintEdges(report);
  PrintProof(report);
  std::cout << "stop            " << report.Text("stop_sentence") << "\n"
            << "seconds         read " << GroupedText(subject.SecondsRead, 2) << ", decimate "
            << seconds("seconds.decimate") << ", measure " << seconds("seconds.measure")
            << ", prove " << seconds("seconds.prove") << ", write "
            << GroupedText(subject.SecondsWrite, 2) << "\n";
  PrintCoordinates(subject);
  for (const std::string& file : written)
  {
    std::cout << "written         " << PlainText(file) << "\n";
  }
  for (const std::string& note : subject.Notes)
  {
    std::cout << "note: " << PlainText(note) << "\n";
  }
  for (const std::string& warning : subject.Warnings)
  {
    std::cout << "warning: " << PlainText(warning) << "\n";
  }
}
}
