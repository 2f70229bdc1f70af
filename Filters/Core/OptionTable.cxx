// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OptionTable.h"

#include "InputOptionRows.h"
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
    { "Mode", &Options::Mode, 0, 3, "", "mode", { "Thesis", "Fast", "Balanced", "Accurate" },
      "How the result is found. Balanced, the default, collapses like Fast, takes the last "
      "triangles by the distance to samples of the original, then moves points and flips edges so "
      "that they come to lie nearer. Accurate does more of each. Fast only collapses edges, "
      "ordered "
      "by what that does to the normals, and very nearly keeps the volume. Thesis takes the vertex "
      "of lowest normal field deviation, then its edge of lowest cost, and goes on while there are "
      "more triangles than asked for or no new point is farther away than MaximumError; the others "
      "end at the first stop reached." },
    { "TargetNumberOfTriangles", &Options::TargetNumberOfTriangles, 0, LargestInteger, "triangles",
      "target-faces", {}, "Number of triangles to reach; 0 is off." },
    { "TargetReduction", &Options::TargetReduction, 0, 1, "", "target-reduction", {},
      "Fraction of the triangles to remove; 1 is off, 0 removes none. The default steps back when "
      "a number of triangles "
      "or a largest error is asked for, or every point has a tolerance." },
    { "MaximumError", &Options::MaximumError, 0, LargestNumber, "mm", "max-error", {},
      "Largest distance in both directions, proved: no point of the input is farther from the "
      "result, and no point of the result farther from the input, open borders curve to curve; 0 "
      "is "
      "off. In Thesis mode it is the distance of a new point at which the collapse stops: exactly "
      "one "
      "point may lie beyond it, and places between points may, too." },
    { "AllowLargeError", &Options::AllowLargeError, 0, 1, "", "allow-large-error", {},
      "Run although the largest error is more than a quarter of the diagonal of the input's "
      "bounding "
      "box. Without it such a run is refused, because the coordinates are probably not in "
      "millimeters." },
    { "KeepClearance", &Options::KeepClearance, 0, 1, "", "keep-clearance", {},
      "With MaximumError: no more pairs of triangles intersect than before, and what faces each "
      "other across a "
      "gap, two fragments or the walls of a fracture, keeps half of the distance that it had. Not "
      "in Thesis mode." },
    { "NormalTolerance", &Options::NormalTolerance, 0, 1, "", "normal-tolerance", {},
      "The tolerance w of the normal field deviation. Smaller values make flat areas dearer; at 1 "
      "a flat edge costs "
      "nothing whatever its length." },
    { "AutomaticNormalTolerance", &Options::AutomaticNormalTolerance, 0, 1, "",
      "auto-normal-tolerance", {},
      "In Thesis mode with a number of triangles or a reduction to reach: NormalTolerance is "
      "chosen by the share of the triangles that stays, 0.95 for half of them or more, 0 for a "
      "tenth or less. The report says which it was." },
  };
}

/// What is done with the input, and what is measured.
std::vector<OptionInfo> RunRows()
{
  return {
    { "MergePoints", &Options::MergePoints, 0, 1, "", "merge-points", {},
      "Merge points with exactly equal coordinates first. Off, triangles that do not share points "
      "are fragments of their "
      "own." },
    { "MeasureDistances", &Options::MeasureDistances, 0, 1, "", "measure", {},
      "Measure the distances between input and result in both directions." },
    { "MeasureInputDistances", &Options::MeasureInputDistances, 0, 1, "", "", {},
      "Return the input with the distance of each of its points to the result." },
    { "NumberOfThreads", &Options::NumberOfThreads, 0, 1024, "threads", "threads", {},
      "Threads to use; 0 is one per processor. The result does not depend on it." },
    { "OutputPointsPrecision", &Options::OutputPointsPrecision, 0, 2, "", "precision",
      { "Single", "Double", "Default" },
      "Precision of the output points; Default is that of the input." },
    { "PassArrays", &Options::PassArrays, 0, 1, "", "pass-arrays", {},
      "Give the result the input's arrays of points and cells: floating values as they are at the "
      "place on the input that "
      "is nearest to the new point, everything else from the nearest point, or the cell nearest to "
      "the middle of the "
      "triangle." },
    { "MakeMaps", &Options::MakeMaps, 0, 1, "", "maps", {},
      "Give the result the arrays OriginalPointIds and OriginalCellIds, nearest point and cell of "
      "the input, and the input "
      "on output port 1 ResultPointIds, the point of the result that each input point became part "
      "of." },
    { "RecomputeNormals", &Options::RecomputeNormals, 0, 1, "", "recompute-normals", {},
      "Give the result point normals of its own triangles, not those of the input." },
  };
}

/// Names of arrays.
std::vector<OptionInfo> ArrayRows()
{
  return {
    { "DistanceArrayName", &Options::DistanceArrayName, 0, 0, "", "", {},
      "Name of the array of the distance of each output point to the input surface, in mm." },
    { "RunningErrorArrayName", &Options::RunningErrorArrayName, 0, 0, "", "", {},
      "Name of the array of the largest distance recorded along the collapses into each output "
      "point, in mm." },
    { "PointCountArrayName", &Options::PointCountArrayName, 0, 0, "", "", {},
      "Name of the array of how many input points each output point stands for." },
    { "InputDistanceArrayName", &Options::InputDistanceArrayName, 0, 0, "", "", {},
      "Name of the array of the distance of each input point to the result, in mm." },
  };
}

/// What is proved.
std::vector<OptionInfo> ProofRows()
{
  return {
    { "ToleranceArrayName", &Options::ToleranceArrayName, 0, 0, "", "tolerance-array", {},
      "Name of a point array of the input, of any type of number, with how far the surface may "
      "move "
      "at each point, in mm: 0 freezes the point with all triangles at it, negative is no limit of "
      "its own, in between it is a largest error there, linear on each triangle and proved like "
      "MaximumError, which caps it. Empty is none. Thesis takes only 0 and negative ones." },
    { "LabelArrayName", &Options::LabelArrayName, 0, 0, "", "labels", {},
      "Name of a cell or point array of whole numbers with the bone, fragment or segment of each "
      "triangle (cells first; of points the majority at the triangle): what lies between different "
      "ones are lines that are simplified only along themselves, and every triangle keeps its "
      "label. Empty is none." },
    { "ProveResult", &Options::ProveResult, 0, 1, "", "prove", {},
      "With MaximumError in every mode but Thesis: certify the result as it is written, both "
      "directions and open borders, and report the proved bounds." },
    { "ErrorBoundArrayName", &Options::ErrorBoundArrayName, 0, 0, "", "", {},
      "Name of the array of the proved bound at each output point, in mm: no point of the "
      "triangles around it is farther from the input. Only with ProveResult." },
    { "InputErrorBoundArrayName", &Options::InputErrorBoundArrayName, 0, 0, "", "", {},
      "Name of the array of the proved bound at each input point, in mm: no point of the triangles "
      "around it is farther from the result. Only with ProveResult and MeasureInputDistances." },
    { "ErrorPreset", &Options::ErrorPreset, 0, 3, "", "preset",
      { "None", "QuarterVoxel", "HalfVoxel", "OneVoxel" },
      "A largest error as a share of the least side of the scan's voxels (VoxelSize); MaximumError "
      "counts, too, if it is smaller. A quarter of a voxel is below what the scan shows, a half "
      "is about how far a surface may be off by the scan alone, one is for overviews." },
    { "VoxelSize", &Options::VoxelSize, 0, LargestNumber, "mm", "voxel-size", {},
      "Least side of the scan's voxels, for ErrorPreset; 0: estimated from the surface, which "
      "must be as marching cubes leaves it, and reported as an estimate." },
  };
}
}

const std::vector<OptionInfo>& OptionTable()
{
  static const std::vector<OptionInfo> table = []
  {
    std::vector<OptionInfo> rows;
    for (const std::vector<OptionInfo>& group :
      { GoalRows(), RunRows(), ArrayRows(), ProofRows(), InputOptionRows() })
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
