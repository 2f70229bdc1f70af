// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Labels/LabelMap/ChangePieces.h"
#include "Labels/LabelMap/LabelSurfaces.h"
#include "Labels/LabelMap/SingleLabel.h"
#include "Labels/LabelMap/VoxelCheck.h"
#include "Labels/ModelGrid/ModelGridChoice.h"
#include "Listener.h"

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <string>

namespace bonedecimate
{
namespace
{
/// Indices z, y, x.
using VolumeIn = nb::ndarray<nb::ro, nb::ndim<3>, nb::c_contig, nb::device::cpu>;
using PairsIn = ArrayIn<std::int64_t, nb::shape<-1, 2>>;
using GridPointsIn = ArrayIn<std::int32_t, nb::shape<-1, 3>>;

/// Integers only; the package around this converts all others.
LabelType TypeOf(const nb::dlpack::dtype& type)
{
  const bool isUnsigned = type.code == static_cast<std::uint8_t>(nb::dlpack::dtype_code::UInt);
  const bool isSigned = type.code == static_cast<std::uint8_t>(nb::dlpack::dtype_code::Int);
  if (!isUnsigned && !isSigned)
  {
    throw nb::type_error("a label map has integers");
  }
  int size = 0;
  while ((8 << size) < type.bits)
  {
    ++size;
  }
  return static_cast<LabelType>(2 * size + (isUnsigned ? 1 : 0));
}

VoxelGrid GridOf(const std::array<double, 3>& origin, const std::array<double, 3>& spacing,
  const std::array<double, 9>& direction, const std::vector<double>& layers,
  const std::array<Index, 3>& dimensions)
{
  VoxelGrid grid;
  grid.Origin = Vector3(origin.data());
  grid.Spacing = Vector3(spacing.data());
  grid.Direction = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(direction.data());
  grid.Dimensions = dimensions;
  grid.Layers = layers;
  return grid;
}

std::array<Index, 3> DimensionsOf(const VolumeIn& volume)
{
  return { static_cast<Index>(volume.shape(2)), static_cast<Index>(volume.shape(1)),
    static_cast<Index>(volume.shape(0)) };
}

std::vector<std::array<std::int64_t, 2>> ValuesOf(const LabelMapSource& source)
{
  std::vector<std::array<std::int64_t, 2>> values;
  values.reserve(source.OfTriangle.size());
  for (const BoundaryLabels& both : source.OfTriangle)
  {
    values.push_back({ source.Values[static_cast<std::size_t>(both[0])],
      source.Values[static_cast<std::size_t>(both[1])] });
  }
  return values;
}

std::vector<double> DirectionOf(const VoxelGrid& grid)
{
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = grid.Direction;
  return std::vector<double>(rows.data(), rows.data() + 9);
}

nb::dict ToDict(LabelSurfaces&& surfaces)
{
  nb::dict fields;
  fields["aborted"] = surfaces.Status == LabelSurfaceStatus::Aborted;
  fields["problem"] = std::string(LabelSurfaceMessage(surfaces.Status));
  auto pairs = ValuesOf(surfaces.Source);
  const std::size_t triangles = pairs.size();
  fields["boundary_labels"] =
    ToArray<std::int64_t, std::array<std::int64_t, 2>>(std::move(pairs), { triangles, 2 });
  fields["points"] = ToRows<double>(std::move(surfaces.Surface.Points));
  fields["triangles"] = ToRows<Index>(std::move(surfaces.Surface.Triangles));
  fields["grid_points"] = ToRows<std::int32_t>(std::move(surfaces.Source.OfPoint));
  fields["label_values"] = ToArray(std::move(surfaces.Source.Values));
  fields["direction"] = ToArray<double, double>(DirectionOf(surfaces.Source.Grid), { 3, 3 });
  return fields;
}

nb::dict Extract(const VolumeIn& labels, const std::array<double, 3>& origin,
  const std::array<double, 3>& spacing, const std::array<double, 9>& direction,
  const std::vector<double>& layers, const std::vector<std::int64_t>& chosen,
  std::int64_t background, bool closed, int threads, nb::object progress)
{
  const LabelImage image = { labels.data(), TypeOf(labels.dtype()),
    GridOf(origin, spacing, direction, layers, DimensionsOf(labels)) };
  const LabelSurfaceOptions options = { chosen, background, closed, threads };
  return ToDict(
    Listener(std::move(progress))
      .Hear([&](const Monitor& monitor) { return ExtractLabelSurfaces(image, options, monitor); }));
}

/// The map of a network, its labels as bytes; None if there is none.
nb::object ModelMap(const VolumeIn& labels, const std::array<double, 3>& origin,
  const std::array<double, 3>& spacing, const std::array<double, 9>& direction,
  const std::vector<double>& layers, const std::string& text)
{
  const ModelGridChoice choice = ReadModelGridChoice(text);
  if (!choice.Problem.empty())
  {
    throw nb::value_error(("model_grid " + choice.Problem).c_str());
  }
  ModelGrid found;
  if (choice.Request)
  {
    const nb::gil_scoped_release others;
    found = FindModelGrid({ labels.data(), TypeOf(labels.dtype()),
                            GridOf(origin, spacing, direction, layers, DimensionsOf(labels)) },
      *choice.Request);
  }
  if (!found.IsFound && choice.IsRequired())
  {
    throw nb::value_error(NoModelGridReason);
  }
  if (!found.IsFound)
  {
    return nb::none();
  }
  const VoxelGrid& grid = found.Grid;
  return nb::make_tuple(nb::bytes(static_cast<const char*>(found.Map().Labels),
                          grid.NumberOfVoxels() * labels.itemsize()),
    grid.Dimensions, std::array<double, 3>{ grid.Origin[0], grid.Origin[1], grid.Origin[2] },
    std::array<double, 3>{ grid.Spacing[0], grid.Spacing[1], grid.Spacing[2] },
    ModelGridSentence(found));
}

using VolumeInOut = nb::ndarray<nb::ndim<3>, nb::c_contig, nb::device::cpu>;

/// One row for each label.
std::vector<std::array<std::int64_t, 4>> RowsOf(const std::vector<SegmentPieces>& segments)
{
  std::vector<std::array<std::int64_t, 4>> rows;
  for (const SegmentPieces& segment : segments)
  {
    rows.push_back(
      { segment.Label, segment.Pieces, segment.Voxels, segment.IsLargestTooSmall ? 1 : 0 });
  }
  return rows;
}

nb::tuple Change(const VolumeInOut& labels, const std::array<double, 3>& origin,
  const std::array<double, 3>& spacing, const std::array<double, 9>& direction,
  const std::vector<double>& layers, const std::vector<std::int64_t>& chosen,
  std::int64_t background, const std::array<double, 3>& islands, double cavityVolume)
{
  const VoxelGrid grid = GridOf(origin, spacing, direction, layers,
    { static_cast<Index>(labels.shape(2)), static_cast<Index>(labels.shape(1)),
      static_cast<Index>(labels.shape(0)) });
  const PieceOptions options = { chosen, background, { islands[0], islands[1], islands[2] },
    cavityVolume };
  PieceCounts counts;
  {
    const nb::gil_scoped_release others;
    counts = ChangePieces(options, labels.data(), TypeOf(labels.dtype()), grid);
  }
  if (!counts.HoldsBackground)
  {
    throw nb::value_error("the type of the labels does not hold the background");
  }
  if (!counts.FitInt64)
  {
    throw nb::value_error(LabelSurfaceMessage(LabelSurfaceStatus::LabelOutOfRange));
  }
  return nb::make_tuple(RowsOf(counts.Islands), RowsOf(counts.Cavities));
}

nb::tuple Single(const PointsIn& points, const TrianglesIn& triangles,
  const PairsIn& boundaryLabels, std::int64_t label)
{
  const Surface surface = ToSurface(points, triangles);
  std::vector<BoundaryLabels> sides(triangles.shape(0));
  const std::int64_t* values = boundaryLabels.data();
  for (std::size_t t = 0; t < sides.size(); ++t)
  {
    sides[t] = { values[2 * t] == label ? 1 : 0, values[2 * t + 1] == label ? 1 : 0 };
  }
  SingleLabelSurface single = ExtractLabel(surface, sides, 1);
  return nb::make_tuple(ToRows<double>(std::move(single.Surface.Points)),
    ToRows<Index>(std::move(single.Surface.Triangles)), ToArray(std::move(single.OriginalPoint)),
    ToArray(std::move(single.OriginalTriangle)));
}

void MakeSource(LabelMapSource* source, const std::array<double, 3>& origin,
  const std::array<double, 3>& spacing, const std::array<double, 9>& direction,
  const std::vector<double>& layers, const std::array<Index, 3>& dimensions,
  std::vector<std::int64_t> values, const std::optional<PairsIn>& boundaryLabels,
  const std::optional<GridPointsIn>& gridPoints)
{
  new (source)
    LabelMapSource{ GridOf(origin, spacing, direction, layers, dimensions), std::move(values) };
  for (std::size_t t = 0; boundaryLabels && t < boundaryLabels->shape(0); ++t)
  {
    const std::int64_t* pair = boundaryLabels->data() + 2 * t;
    source->OfTriangle.push_back({ static_cast<Index>(pair[0]), static_cast<Index>(pair[1]) });
  }
  for (std::size_t p = 0; gridPoints && p < gridPoints->shape(0); ++p)
  {
    const std::int32_t* center = gridPoints->data() + 3 * p;
    source->OfPoint.push_back({ center[0], center[1], center[2] });
  }
}

nb::dict ToDict(const VoxelChanges& changes)
{
  std::vector<std::array<std::int64_t, 3>> ofLabel;
  for (const LabelChanges& label : changes.OfLabel)
  {
    ofLabel.push_back({ label.Voxels, label.Lost, label.Gained });
  }
  nb::dict fields;
  fields["aborted"] = !changes.IsDone;
  fields["compared"] = changes.Compared;
  fields["changed"] = changes.Changed;
  fields["first_changed"] = changes.FirstChanged;
  fields["of_label"] = ToRows<std::int64_t>(std::move(ofLabel));
  return fields;
}

nb::dict Check(const VolumeIn& labels, const LabelMapSource& source, const PointsIn& points,
  const TrianglesIn& triangles, int threads, nb::object progress)
{
  const LabelImage image = { labels.data(), TypeOf(labels.dtype()), source.Grid };
  const Surface surface = ToSurface(points, triangles);
  const VoxelCheckSettings settings = { source.Grid, static_cast<Index>(source.Values.size()),
    threads };
  return ToDict(Listener(std::move(progress))
                  .Hear(
                    [&](const Monitor& monitor)
                    {
                      return CompareVoxels(
                        image, source.Values, { surface, source.OfTriangle }, settings, monitor);
                    }));
}
}

//------------------------------------------------------------------------------
void BindLabelMaps(nb::module_& module)
{
  module.def("extract_surfaces", &Extract, nb::arg("labels"), nb::arg("origin"), nb::arg("spacing"),
    nb::arg("direction"), nb::arg("layers"), nb::arg("chosen"), nb::arg("background"),
    nb::arg("closed"), nb::arg("threads"), nb::arg("progress").none(),
    "The surfaces of a label map with indices z, y, x; the direction is row by row.");
  module.def("model_map", &ModelMap, nb::arg("labels"), nb::arg("origin"), nb::arg("spacing"),
    nb::arg("direction"), nb::arg("layers"), nb::arg("choice"),
    "The map of a network from which a label map was copied: labels, dimensions, origin, spacing "
    "and "
    "a sentence; None if there is none.");
  module.def("change_pieces", &Change, nb::arg("labels"), nb::arg("origin"), nb::arg("spacing"),
    nb::arg("direction"), nb::arg("layers"), nb::arg("chosen"), nb::arg("background"),
    nb::arg("islands"), nb::arg("cavity_volume"),
    "Changes a label map with indices z, y, x; islands are the least size, area and volume. Rows "
    "of label, pieces, voxels and whether the largest piece is too small: of islands, of "
    "cavities.");
  module.def("extract_label", &Single, nb::arg("points"), nb::arg("triangles"),
    nb::arg("boundary_labels"), nb::arg("label"),
    "Points, triangles, original points and original triangles of one label.");
  nb::class_<LabelMapSource>(module, "LabelMapSource",
    "What is known of the label map of a surface; the boundary labels are indices into the values.")
    .def("__init__", &MakeSource, nb::arg("origin"), nb::arg("spacing"), nb::arg("direction"),
      nb::arg("layers"), nb::arg("dimensions"), nb::arg("values"),
      nb::arg("boundary_labels").none(), nb::arg("grid_points").none());
  module.def("check_voxels", &Check, nb::arg("labels"), nb::arg("source"), nb::arg("points"),
    nb::arg("triangles"), nb::arg("threads"), nb::arg("progress").none(),
    "Compares a label map with indices z, y, x, on the grid of the source, with a surface whose "
    "points and indices are valid.");
}
}
