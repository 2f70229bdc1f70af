// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include "InputOptionRows.h"
#include "Modes.h"
#include "NumberRange.h"

#include <limits>

namespace bonedecimate
{
namespace
{
constexpr double LargestInteger = std::numeric_limits<int>::max();

/// What to reach, and how.
std::vector<OptionInfo> GoalRows()
{
  return {
    { "Mode", &Options::Mode, 0, static_cast<double>(ModeTable().size() - 1), "", "mode",
      ModeNames(),
      "Decimation mode. Thesis follows Brandao (2018). Fast orders edges by the change of the "
      "normals that a collapse causes, and nearly preserves the volume. Balanced adds collapses "
      "ordered by sampled error, edge flips and vertex moves. Accurate does more of these. Thesis "
      "continues until the number of triangles is reached and, with MaximumError, a new vertex "
      "lies beyond it; the other modes stop at the first criterion that is met." },
    { "TargetNumberOfTriangles", &Options::TargetNumberOfTriangles, 0, LargestInteger, "triangles",
      "target-triangles", {}, "Number of triangles to reach. 0: off." },
    { "TargetReduction", &Options::TargetReduction, 0, 1, "", "target-reduction", {},
      "Fraction of the triangles to remove. 0: remove none; 1: off. The default is ignored if a "
      "number of triangles or a largest error is set, if every point has a tolerance, or if "
      "KeepVoxels is On." },
    { "MaximumError", &Options::MaximumError, 0, LargestNumber, "mm", "max-error", {},
      "Largest distance between input and result, proved in both directions for every point of "
      "both surfaces, and for open boundaries curve to curve. 0: off. In Thesis mode the run stops "
      "at the first new vertex that is farther from the input: one vertex can exceed the value, "
      "and points between vertices can, too." },
    { "AllowLargeError", &Options::AllowLargeError, 0, 1, "", "allow-large-error", {},
      "Accept a largest error above a quarter of the diagonal of the input's bounding box. Without "
      "it such a run is rejected, because the coordinates are probably not in millimeters." },
    { "IntersectionGuard", &Options::IntersectionGuard, 0, 1, "", "intersection-guard", {},
      "With MaximumError, except in Thesis mode: the number of intersecting pairs of triangles "
      "does not increase, and gaps between fragments and between facing walls keep at least half "
      "of their width." },
    { "RefinementEffort", &Options::RefinementEffort, 0, 100, "", "refinement-effort", {},
      "With a largest error or tolerances, modes Balanced and Accurate: how many rounds of moves "
      "and collapses remove triangles after those of Fast, relative to the rounds of the mode and "
      "rounded. More rounds take longer and mostly leave fewer triangles. 0: none." },
    { "MinimumAngle", &Options::MinimumAngle, 0, 40, "degrees", "min-angle", {},
      "Smallest angle of the triangles of the result, except in Thesis mode: for solvers, meshers "
      "and printers. Edits make no triangle with a smaller one, and triangles of the input that "
      "have one are improved by collapses, flips and moves where everything else that was "
      "requested "
      "allows it; the report counts those that are left. The number of triangles for a largest "
      "error rises: by a tenth to two fifths at 20 degrees, by two fifths up to double at 30. 0: "
      "off." },
    { "EdgeLength", &Options::EdgeLength, 0, LargestNumber, "mm", "edge-length", {},
      "Length that the edges of the result are to have, except in Thesis mode: for solvers and "
      "meshers. Edges longer than 4/3 of it are split, edges shorter than 4/5 collapsed where "
      "everything else that was requested allows it, and flips and moves even out the triangles. "
      "No "
      "collapse makes an edge longer than 4/3. There are never more triangles than in the input or "
      "than requested, and levels of detail have no splits; the report counts the edges that are "
      "left. Without MinimumAngle no edit makes "
      "an angle below 20 degrees. 0: off." },
    { "ChordalError", &Options::ChordalError, 0, LargestNumber, "mm", "chordal-error", {},
      "With EdgeLength: edges are shorter where the surface is curved, so that an equilateral "
      "triangle with its corners on a sphere of the local curvature lies at most this far below "
      "it. Lengths are not shortened below a tenth of EdgeLength, and grow by at most 0.3 mm for "
      "each mm along the surface. The curvature is that of the input, averaged within a quarter of "
      "EdgeLength. 0: off." },
  };
}

/// What is done before the first edit, what voxels keep, and options of mode Thesis.
std::vector<OptionInfo> SurfaceRows()
{
  return {
    { "Smoothing", &Options::Smoothing, 0, LargestNumber, "mm", "smooth", {},
      "Smooth the surface before the first edit: no point moves by more than this, nor by more "
      "than MaximumError and its tolerance allow. Both steps together keep MaximumError relative "
      "to the "
      "input. Of the surface of a binary segmentation every voxel keeps its label in this step. "
      "0: off." },
    { "AutomaticSmoothing", &Options::AutomaticSmoothing, 0, 1, "", "auto-smooth", {},
      "Smooth the surface of a binary segmentation by its voxel size, if Smoothing is 0: by half "
      "of "
      "the smallest voxel spacing, or by a third of a MaximumError or tolerance below that "
      "spacing. "
      "The voxel grid is found in the surface; any other surface is left as it is." },
    { "FeatureAngle", &Options::FeatureAngle, 0, 180, "degrees", "feature-angle", {},
      "Smoothing keeps an edge sharp if the normals on its two sides, each averaged over about two "
      "voxels, differ by more than this. 180: off; 45 suits cuts, implants and fractures." },
    { "KeepVoxels", &Options::KeepVoxels, 0, 2, "", "keep-voxels", { "Off", "On", "Auto" },
      "For surfaces of label maps: reject every edit that lets a voxel center change sides, so "
      "that "
      "the result, voxelized again, gives every voxel the label it had. Auto: on without a largest "
      "error or with one of at most half a voxel. On alone, without a target or a largest error, "
      "continues until no edit is possible. Needs the voxel grid of the surface." },
    { "NormalTolerance", &Options::NormalTolerance, 0, 1, "", "normal-tolerance", {},
      "Thesis mode: tolerance w of the normal field deviation. Smaller values raise the cost of "
      "flat regions. At 1 an edge between coplanar triangles costs nothing, whatever its length." },
    { "AutomaticNormalTolerance", &Options::AutomaticNormalTolerance, 0, 1, "",
      "auto-normal-tolerance", {},
      "Thesis mode with a number of triangles or a reduction: choose NormalTolerance from the "
      "fraction of triangles that remains, from 0.95 for one half or more to 0 for one tenth or "
      "less. The report contains the value." },
  };
}

/// What is done with the input, and what is measured.
std::vector<OptionInfo> RunRows()
{
  return {
    { "MergePoints", &Options::MergePoints, 0, 1, "", "merge-points", {},
      "Merge points with exactly equal coordinates before the run. If off, triangles without "
      "common point ids belong to different fragments." },
    { "MeasureDistances", &Options::MeasureDistances, 0, 1, "", "measure", {},
      "Measure the distances between input and result in both directions." },
    { "MeasureInputDistances", &Options::MeasureInputDistances, 0, 1, "", "", {},
      "Return the input on output port 1 with the distance of each point to the result." },
    { "NumberOfThreads", &Options::NumberOfThreads, 0, 1024, "threads", "threads", {},
      "Number of threads. 0: one per processor. The result does not depend on it." },
    { "OutputPointsPrecision", &Options::OutputPointsPrecision, 0, 2, "", "precision",
      { "Single", "Double", "Default" },
      "Precision of the output points. Default: that of the input." },
    { "OutputPointsGrid", &Options::OutputPointsGrid, 0, LargestNumber, "mm", "", {},
      "Round the output points to whole multiples of this length, for files that hold whole "
      "numbers. What is proved, and what the guards check, are the rounded points. A power of two "
      "is exact in single precision. 0: off." },
    { "PassArrays", &Options::PassArrays, 0, 1, "", "pass-arrays", {},
      "Pass the point and cell arrays of the input to the result. Floating-point point data is "
      "interpolated at the nearest position on the input. Everything else is copied from the "
      "nearest point, or from the cell nearest to the centroid of the triangle." },
    { "MakeMaps", &Options::MakeMaps, 0, 1, "", "maps", {},
      "Add the arrays OriginalPointIds and OriginalCellIds to the result: the nearest point and "
      "cell of the input. Add the array ResultPointIds to the input on output port 1: the output "
      "point into which each input point was merged." },
    { "RecomputeNormals", &Options::RecomputeNormals, 0, 1, "", "recompute-normals", {},
      "Compute point normals from the triangles of the result instead of passing those of the "
      "input." },
  };
}

/// Names of arrays.
std::vector<OptionInfo> ArrayRows()
{
  return {
    { "DistanceArrayName", &Options::DistanceArrayName, 0, 0, "", "", {},
      "Name of the point array with the distance of each output point to the input surface, in "
      "mm." },
    { "RunningErrorArrayName", &Options::RunningErrorArrayName, 0, 0, "", "", {},
      "Name of the point array with the running error: the largest distance recorded along the "
      "collapses into each output point, in mm." },
    { "PointCountArrayName", &Options::PointCountArrayName, 0, 0, "", "", {},
      "Name of the point array with the number of input points that each output point "
      "represents." },
    { "InputDistanceArrayName", &Options::InputDistanceArrayName, 0, 0, "", "", {},
      "Name of the point array with the distance of each input point to the result, in mm." },
  };
}

/// What is proved.
std::vector<OptionInfo> ProofRows()
{
  return {
    { "ToleranceArrayName", &Options::ToleranceArrayName, 0, 0, "", "tolerance-array", {},
      "Name of a numeric point array of the input with the largest error at each point, in mm. 0 "
      "keeps the point and its triangles unchanged. A negative value sets no limit. A positive "
      "value is interpolated linearly on each triangle and proved like MaximumError, which is an "
      "upper limit for all. Thesis mode accepts only 0 and negative values. Empty: none." },
    { "EdgeLengthArrayName", &Options::EdgeLengthArrayName, 0, 0, "", "edge-length-array", {},
      "With EdgeLength: name of a numeric point array of the input with the length that edges are "
      "to have at each point, in mm, above 0. EdgeLength is an upper limit for all. Lengths grow "
      "by at most 0.3 mm for each mm along the surface. Empty: none." },
    { "LabelArrayName", &Options::LabelArrayName, 0, 0, "", "labels", {},
      "Name of an integer cell or point array with the bone, fragment or segment of each triangle. "
      "A cell array takes precedence; of a point array the majority of the three corners counts. "
      "Curves between different labels are simplified only along themselves, and every triangle "
      "keeps its label. Empty: none." },
    { "ProveResult", &Options::ProveResult, 0, 1, "", "prove", {},
      "With MaximumError, except in Thesis mode: certify the result as it is written, in both "
      "directions and for open boundaries, and report the proved bounds." },
    { "ErrorBoundArrayName", &Options::ErrorBoundArrayName, 0, 0, "", "", {},
      "Name of the point array with the proved bound at each output point, in mm: no point of the "
      "adjacent triangles is farther from the input. Needs ProveResult." },
    { "InputErrorBoundArrayName", &Options::InputErrorBoundArrayName, 0, 0, "", "", {},
      "Name of the point array with the proved bound at each input point, in mm: no point of the "
      "adjacent triangles is farther from the result. Needs ProveResult and "
      "MeasureInputDistances." },
    { "ErrorPreset", &Options::ErrorPreset, 0, 3, "", "preset",
      { "None", "QuarterVoxel", "HalfVoxel", "OneVoxel" },
      "Largest error as a fraction of the smallest voxel spacing of the scan (VoxelSize). A "
      "quarter is below the resolution of the scan, a half is about the uncertainty of a surface "
      "from the scan, one voxel is for overviews. A smaller MaximumError takes precedence." },
    { "VoxelSize", &Options::VoxelSize, 0, LargestNumber, "mm", "voxel-size", {},
      "Smallest voxel spacing of the scan, for ErrorPreset. 0: estimated from the surface, which "
      "must be unmodified output of marching cubes, and reported as an estimate." },
  };
}
}

const std::vector<OptionInfo>& OptionTable()
{
  static const std::vector<OptionInfo> table = []
  {
    std::vector<OptionInfo> rows;
    for (const std::vector<OptionInfo>& group :
      { GoalRows(), SurfaceRows(), RunRows(), ArrayRows(), ProofRows(), InputOptionRows() })
    {
      rows.insert(rows.end(), group.begin(), group.end());
    }
    return rows;
  }();
  return table;
}

const OptionInfo* FindOption(const std::string& name)
{
  for (const OptionInfo& info : OptionTable())
  {
    if (info.Name == name)
    {
      return &info;
    }
  }
  return nullptr;
}
}
