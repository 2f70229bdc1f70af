// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelSurfaces.h"

#include "Base/LargeArray.h"
#include "Base/Parallel.h"
#include "LabelRanks.h"
#include "LayerSweep.h"
#include "VoxelLayers.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr Index LayersPerPart = 8;
constexpr std::int64_t MaxIndex = std::numeric_limits<Index>::max();
constexpr Index MaxDimension = (1 << 30) - 2;     // twice a padded coordinate is an index
constexpr double OrthogonalButForRounding = 1e-3; // as program and wheel
constexpr double Orthogonal = 1e-14;

double DeviationFromOrthogonal(const Eigen::Matrix3d& matrix)
{
  return (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

/// The nearest orthogonal axes, by Newton's iteration for the polar decomposition, if the axes are
/// orthogonal up to rounding. Those of a sheared grid are kept.
Eigen::Matrix3d NearestDirection(Eigen::Matrix3d matrix)
{
  if (!(DeviationFromOrthogonal(matrix) <= OrthogonalButForRounding))
  {
    return matrix;
  }
  for (int step = 0; step < 4 && DeviationFromOrthogonal(matrix) > Orthogonal; ++step)
  {
    matrix = (0.5 * (matrix + matrix.inverse().transpose())).eval();
  }
  return matrix;
}

LabelSurfaceStatus CheckGrid(const VoxelGrid& grid, const LabelSurfaceOptions& options)
{
  const auto [least, largest] = std::minmax_element(grid.Dimensions.begin(), grid.Dimensions.end());
  if (*least < 1 || *largest > MaxDimension)
  {
    return LabelSurfaceStatus::NoVoxels;
  }
  VoxelGrid rounded = grid;
  rounded.Direction = NearestDirection(grid.Direction);
  if (!rounded.IsValid())
  {
    return LabelSurfaceStatus::BadGrid;
  }
  const std::optional<LayerRange>& slab = options.Slab;
  if (slab && (slab->First < 0 || slab->First >= slab->Last || slab->Last >= grid.Dimensions[2]))
  {
    return LabelSurfaceStatus::BadSlab;
  }
  return *least < 2 && !options.Closed ? LabelSurfaceStatus::TooThin : LabelSurfaceStatus::Good;
}

/// The options' labels, ascending, each once.
std::vector<std::int64_t> ChosenLabels(const LabelSurfaceOptions& options)
{
  std::vector<std::int64_t> labels = options.Labels;
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

/// The monitor of a phase: values, counts or surface.
Monitor MonitorOf(const Monitor& monitor, double from, double to)
{
  return monitor ? PartOf(monitor, from, to) : monitor;
}

class Extraction
{
public:
  Extraction(const LabelImage& image, const LabelSurfaceOptions& options, const Monitor& monitor)
    : Image(image)
    , Options(options)
    , Progress(monitor)
  {
  }

  LabelSurfaces Run()
  {
    this->Result.Status = CheckGrid(this->Image.Grid, this->Options);
    if (this->IsGood())
    {
      this->Result.Source.Grid = this->Image.Grid;
      this->Result.Source.Grid.Direction = NearestDirection(this->Image.Grid.Direction);
      this->FindLabels();
    }
    if (this->IsGood())
    {
      this->Sweep();
    }
    if (!this->IsGood())
    {
      const LabelSurfaceStatus status = this->Result.Status;
      this->Result = LabelSurfaces();
      this->Result.Status = status;
    }
    return std::move(this->Result);
  }

private:
  bool IsGood() const { return this->Result.Status == LabelSurfaceStatus::Good; }

  LayerRange Layers() const
  {
    return this->Options.Slab.value_or(LayerRange{ 0, this->Image.Grid.Dimensions[2] - 1 });
  }

  void FindLabels()
  {
    std::vector<std::int64_t> labels = ChosenLabels(this->Options);
    if (labels.empty())
    {
      LabelImage inMemory = this->Image;
      inMemory.Grid.Dimensions[2] = this->Layers().Count(); // its layers count alone
      LabelValues found =
        FindLabelValues(inMemory, this->Options.Threads, MonitorOf(this->Progress, 0.0, 0.1));
      this->Result.Status = !found.IsComplete ? LabelSurfaceStatus::Aborted
        : !found.FitInt64                     ? LabelSurfaceStatus::LabelOutOfRange
                                              : LabelSurfaceStatus::Good;
      labels = std::move(found.Values);
    }
    labels.erase(std::remove(labels.begin(), labels.end(), this->Options.Background), labels.end());
    if (this->IsGood() && this->Options.Labels.empty() && labels.size() > MaxLabels)
    {
      this->Result.Status = LabelSurfaceStatus::TooManyLabels;
    }
    labels.push_back(this->Options.Background);
    this->Result.Source.Values = std::move(labels);
  }

  void Sweep()
  {
    std::vector<std::int64_t> labels = this->Result.Source.Values;
    labels.pop_back();
    const LabelRanks ranks(std::move(labels));
    const VoxelLayers layers(this->Image, this->Layers(), ranks, this->Options.Closed);
    std::vector<LayerCounts> counts(static_cast<std::size_t>(layers.Depth()));
    if (!this->Count(layers, counts))
    {
      this->Result.Status = LabelSurfaceStatus::Aborted;
    }
    else if (!this->Allocate(counts))
    {
      this->Result.Status = LabelSurfaceStatus::TooLarge;
    }
    else if (!this->Write(layers, Starts(counts)))
    {
      this->Result.Status = LabelSurfaceStatus::Aborted;
    }
  }

  /// Calls work(first layer, last layer) for each part; false after an abort.
  template <typename Work>
  bool ForEachPartOf(const VoxelLayers& layers, const Monitor& monitor, const Work& work) const
  {
    const Index depth = layers.Depth();
    const auto parts = static_cast<std::size_t>((depth + LayersPerPart - 1) / LayersPerPart);
    return ForEachPart(parts, this->Options.Threads, monitor,
      [&](std::size_t part)
      {
        const Index first = static_cast<Index>(part) * LayersPerPart;
        work(first, std::min(depth, first + LayersPerPart));
      });
  }

  bool Count(const VoxelLayers& layers, std::vector<LayerCounts>& counts) const
  {
    return this->ForEachPartOf(layers, MonitorOf(this->Progress, 0.1, 0.4),
      [&](Index first, Index last)
      { LayerCounter(layers).Count(first, last, counts.data() + first); });
  }

  bool Allocate(const std::vector<LayerCounts>& counts)
  {
    std::int64_t points = 0;
    std::int64_t triangles = 0;
    for (const LayerCounts& layer : counts)
    {
      points += layer.Points();
      triangles += layer.Triangles;
    }
    if (points > MaxIndex || triangles > MaxIndex)
    {
      return false;
    }
    Resize(this->Result.Surface.Points, points);
    Resize(this->Result.Source.OfPoint, points);
    Resize(this->Result.Surface.Triangles, triangles);
    Resize(this->Result.Source.OfTriangle, triangles);
    return true;
  }

  template <typename Value>
  static void Resize(std::vector<Value>& values, std::int64_t size)
  {
    ReserveLarge(values, static_cast<std::size_t>(size));
    values.resize(static_cast<std::size_t>(size));
  }

  static std::vector<LayerStart> Starts(const std::vector<LayerCounts>& counts)
  {
    std::vector<LayerStart> starts;
    starts.reserve(counts.size());
    std::int64_t point = 0;
    std::int64_t triangle = 0;
    for (const LayerCounts& layer : counts)
    {
      starts.push_back({ static_cast<Index>(point), static_cast<Index>(point + layer.InLayer),
        static_cast<Index>(point + layer.InLayer + layer.Between), static_cast<Index>(triangle) });
      point += layer.Points();
      triangle += layer.Triangles;
    }
    return starts;
  }

  bool Write(const VoxelLayers& layers, const std::vector<LayerStart>& starts)
  {
    return this->ForEachPartOf(layers, MonitorOf(this->Progress, 0.4, 1.0),
      [&](Index first, Index last)
      { LayerWriter(layers, starts, this->Result).Write(first, last); });
  }

  const LabelImage& Image;
  const LabelSurfaceOptions& Options;
  const Monitor& Progress;
  LabelSurfaces Result;
};
}

//------------------------------------------------------------------------------
const char* LabelSurfaceMessage(LabelSurfaceStatus status)
{
  static constexpr std::array<const char*, NumberOfLabelSurfaceStatuses> messages = { "",
    "the label map has no voxels, or more than 2^30 - 2 along an axis",
    "the label map is one voxel thin; extract closed surfaces",
    "the grid of the label map needs finite values, a positive spacing, unit vectors that are not "
    "in one plane as axes, and positions of layers that ascend from 0, if there are any",
    "a label is larger than 2^63 - 1",
    "the image has more than 1,000 different values, which are no labels: gray values have to be "
    "segmented first, or labels chosen",
    "the surfaces have more than 2^31 - 1 points or triangles", "the extraction was aborted",
    "a slab of a label map needs at least two of its layers" };
  return messages[static_cast<std::size_t>(status)];
}

//------------------------------------------------------------------------------
LabelSurfaces ExtractLabelSurfaces(
  const LabelImage& image, const LabelSurfaceOptions& options, const Monitor& monitor)
{
  return Extraction(image, options, monitor).Run();
}
}
