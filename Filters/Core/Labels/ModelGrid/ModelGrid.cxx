// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ModelGrid.h"

#include "Base/Parallel.h"
#include "ChangePlanes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace bonedecimate
{
namespace
{
constexpr double MaxChance = 1e-6;      // of all axes together
constexpr double MaxChanceOfAxis = 0.1; // of each that counts
constexpr std::size_t MinChanges = 4;   // layers with changes along each axis
constexpr double MinDensity = 0.5;      // ratio of these between the first and the last
constexpr double MinOblique = 0.004;    // ratio of the points on boundaries, IsCurved()
/// The same as a ratio of the square root of these points. The steps of an oblique plane are
/// regular along one axis.
constexpr double MinObliqueOfRoot = 0.5;
constexpr double MinObliqueOfOneAxis = 1.0;
constexpr double MaxDifferent = 0.01; // ratio of voxels to changes
constexpr double FewChanges = 4.0;    // of a layer
constexpr double NoisyLayer = 0.05;   // of the median of the changes of a layer
/// Tolerances of the spacing: programs change it so that samples fit between the outermost layers.
constexpr std::array<double, 3> SpacingTolerances = { 0.001, 0.01, 0.05 };
constexpr double UsualSpacing = 0.05; // mm; spacings of models are whole multiples

std::vector<Index> LayersAbove(const PlaneCounts& counts, double least)
{
  std::vector<Index> layers;
  for (std::size_t i = 1; i < counts.size(); ++i)
  {
    if (static_cast<double>(counts[i]) > least)
    {
      layers.push_back(static_cast<Index>(i));
    }
  }
  return layers;
}

double MedianOf(PlaneCounts counts)
{
  counts.erase(std::remove(counts.begin(), counts.end(), 0), counts.end());
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return counts.empty() ? 0.0 : static_cast<double>(*middle);
}

class Search
{
public:
  Search(const LabelImage& image, const ModelGridRequest& request)
    : Image(image)
    , Request(request)
    , Counts(CountPlaneChanges(image, request.Threads))
  {
  }

  ModelGrid Run()
  {
    ModelGrid found = this->Try(false);
    return found.IsFound ? found : this->Try(true);
  }

private:
  /// @param isNoisy Whether layers with few changes are ignored.
  ModelGrid Try(bool isNoisy) const
  {
    ModelGrid model;
    bool isDense = true;
    int coarserAxes = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const PlaneCounts& counts = this->Counts[axis];
      const std::vector<Index> changes =
        LayersAbove(counts, isNoisy ? std::max(FewChanges, NoisyLayer * MedianOf(counts)) : 0.0);
      AxisCells& cells = model.Axes[axis];
      cells = this->CellsAlong(axis, changes);
      model.Chance *= cells.Chance;
      coarserAxes += cells.IsFound() ? 1 : 0;
      isDense = isDense && changes.size() >= MinChanges &&
        (cells.IsFound() || this->IsUneven(axis) ||
          static_cast<double>(changes.size()) >=
            MinDensity * (changes.back() - changes.front() + 1.0));
    }
    const bool isRequested = this->Request.Spacing.has_value();
    if (coarserAxes > 0 && (isRequested || (isDense && model.Chance < MaxChance)))
    {
      this->ReadMap(model);
      model.IsFound = this->IsAlike(model) &&
        (isRequested || IsCurved(model, coarserAxes == 1 ? MinObliqueOfOneAxis : MinObliqueOfRoot));
    }
    return model;
  }

  bool IsUneven(std::size_t axis) const { return axis == 2 && this->Image.Grid.HasLayers(); }

  AxisCells CellsAlong(std::size_t axis, const std::vector<Index>& changes) const
  {
    const Index layers = this->Image.Grid.Dimensions[axis];
    const double spacing = this->Image.Grid.Spacing[static_cast<Eigen::Index>(axis)];
    if (this->IsUneven(axis))
    {
      return CellsOfLayers(layers);
    }
    if (!this->Request.Spacing)
    {
      const auto cells = FindAxisCells(changes, layers, { 1.0, 0.0, UsualSpacing / spacing });
      return cells && cells->Chance < MaxChanceOfAxis ? *cells : CellsOfLayers(layers);
    }
    const double length = (*this->Request.Spacing)[static_cast<Eigen::Index>(axis)] / spacing;
    for (const double tolerance : SpacingTolerances)
    {
      const CellLengths range = { (1.0 - tolerance) * length, (1.0 + tolerance) * length, length };
      const auto cells =
        length > 1.0 ? FindAxisCells(changes, layers, range) : std::optional<AxisCells>();
      if (cells)
      {
        return *cells;
      }
    }
    return CellsOfLayers(layers);
  }

  void ReadMap(ModelGrid& model) const
  {
    const VoxelGrid& grid = this->Image.Grid;
    model.Grid = grid;
    Vector3 first;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto k = static_cast<Eigen::Index>(axis);
      const AxisCells& cells = model.Axes[axis];
      model.Grid.Dimensions[axis] = cells.Count();
      model.Grid.Spacing[k] = grid.Spacing[k] * cells.Length;
      first[k] = cells.FirstSample;
    }
    model.Grid.Origin = grid.ToMillimeters(first);
    model.Type = this->Image.Type;
    WithLabelsOf(this->Image, [&](const auto* labels) { this->CopyAndCompare(labels, model); });
  }

  template <typename Label>
  void CopyAndCompare(const Label* labels, ModelGrid& model) const
  {
    const std::size_t cells = model.Grid.NumberOfVoxels();
    model.Labels.resize(
      (cells * sizeof(Label) + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    auto* const map = reinterpret_cast<Label*>(model.Labels.data());
    std::array<std::vector<std::size_t>, 3> middle;
    std::transform(model.Axes.begin(), model.Axes.end(), middle.begin(), MiddleLayers);
    const std::array<std::size_t, 2> size = { middle[0].size(), middle[1].size() };
    const auto columns = static_cast<std::size_t>(this->Image.Grid.Dimensions[0]);
    const auto rows = static_cast<std::size_t>(this->Image.Grid.Dimensions[1]);
    ForEachPart(middle[2].size(), this->Request.Threads, Monitor(),
      [&](std::size_t z)
      {
        for (std::size_t y = 0; y < size[1]; ++y)
        {
          const Label* const row = labels + (middle[2][z] * rows + middle[1][y]) * columns;
          std::transform(middle[0].begin(), middle[0].end(), map + (z * size[1] + y) * size[0],
            [row](std::size_t x) { return row[x]; });
        }
      });
    this->Compare(labels, map, model);
  }

  static std::vector<std::size_t> MiddleLayers(const AxisCells& cells)
  {
    std::vector<std::size_t> middle;
    std::size_t first = 0;
    for (std::size_t i = 1; i <= cells.OfLayer.size(); ++i)
    {
      if (i == cells.OfLayer.size() || cells.OfLayer[i] != cells.OfLayer[first])
      {
        middle.push_back((first + i - 1) / 2);
        first = i;
      }
    }
    return middle;
  }

  template <typename Label>
  void Compare(const Label* labels, const Label* map, ModelGrid& model) const
  {
    struct Layer
    {
      std::int64_t Different = 0;
      std::size_t First = 0;
    };
    const auto& [columns, rows, layers] = this->Image.Grid.Dimensions;
    const std::size_t inLayer = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    std::vector<Layer> found(static_cast<std::size_t>(layers));
    ForEachPart(found.size(), this->Request.Threads, Monitor(),
      [&, columns = static_cast<std::size_t>(columns)](std::size_t z)
      {
        const auto mapLayer = static_cast<std::size_t>(model.Axes[2].OfLayer[z]) *
          static_cast<std::size_t>(model.Grid.Dimensions[1]);
        for (std::size_t i = 0; i < inLayer; i += columns)
        {
          const Label* const row = labels + z * inLayer + i;
          const Label* const cells = map +
            (mapLayer + static_cast<std::size_t>(model.Axes[1].OfLayer[i / columns])) *
              static_cast<std::size_t>(model.Grid.Dimensions[0]);
          for (std::size_t x = 0; x < columns; ++x)
          {
            if (row[x] != cells[model.Axes[0].OfLayer[x]] && found[z].Different++ == 0)
            {
              found[z].First = i + x;
            }
          }
        }
      });
    for (std::size_t z = 0; z < found.size(); ++z)
    {
      if (model.Different == 0 && found[z].Different > 0)
      {
        const auto first = static_cast<Index>(found[z].First);
        model.FirstDifferent = { first % columns, first / columns, static_cast<Index>(z) };
      }
      model.Different += found[z].Different;
    }
  }

  bool IsAlike(const ModelGrid& model) const
  {
    std::int64_t changes = 0;
    for (const PlaneCounts& counts : this->Counts)
    {
      changes = std::accumulate(counts.begin(), counts.end(), changes);
    }
    return static_cast<double>(model.Different) <= MaxDifferent * static_cast<double>(changes);
  }

  /// Whether the surface has the steps of a curved one, which blocks and extruded shapes do not
  /// have: points about which a cell and its three neighbors are on one side, and the four others
  /// on the other side.
  static bool IsCurved(const ModelGrid& model, double minOfRoot)
  {
    return WithLabelsOf(model.Map(),
      [&](const auto* map)
      {
        using Label = std::decay_t<decltype(*map)>;
        std::int64_t boundary = 0;
        std::int64_t oblique = 0;
        const auto& [columns, rows, layers] = model.Grid.Dimensions;
        const std::ptrdiff_t row = columns;
        const std::ptrdiff_t layer = row * rows;
        for (std::ptrdiff_t last = layer + row + 1; last < layer * layers; ++last)
        {
          // Blocks of 2 x 2 x 2 cells that go around the end of a row count as well.
          std::array<Label, 8> cells;
          for (std::size_t i = 0; i < 8; ++i)
          {
            cells[i] = map[last - ((i & 1) == 0) - ((i & 2) == 0) * row - ((i & 4) == 0) * layer];
          }
          const bool isBoundary =
            std::any_of(cells.begin(), cells.end(), [&](Label cell) { return cell != cells[0]; });
          boundary += isBoundary ? 1 : 0;
          oblique += isBoundary && IsOblique(cells) ? 1 : 0;
        }
        const auto points = static_cast<double>(boundary);
        return static_cast<double>(oblique) >=
          std::max(MinOblique * points, minOfRoot * std::sqrt(points));
      });
  }

  template <typename Label>
  static bool IsOblique(const std::array<Label, 8>& cells)
  {
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      const auto isSame = [&](std::size_t bits) { return cells[corner ^ bits] == cells[corner]; };
      if (isSame(1) && isSame(2) && isSame(4) && !isSame(3) && !isSame(5) && !isSame(6) &&
        !isSame(7))
      {
        return true;
      }
    }
    return false;
  }

  const LabelImage& Image;
  const ModelGridRequest& Request;
  std::array<PlaneCounts, 3> Counts;
};
}

ModelGrid FindModelGrid(const LabelImage& image, const ModelGridRequest& request)
{
  const std::array<Index, 3>& size = image.Grid.Dimensions;
  const Index least = request.Spacing ? 1 : static_cast<Index>(MinChanges) + 1;
  if (!image.Grid.IsValid() || *std::min_element(size.begin(), size.end()) < least)
  {
    return {};
  }
  return Search(image, request).Run();
}
}
