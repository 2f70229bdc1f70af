// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BindDecimate.h"

#include "Arrays.h"
#include "Bindings.h"
#include "Listener.h"
#include "Mesh/Checksum.h"
#include "Partition/Regions/RegionCache.h"
#include "Run/Report/ProofSentence.h"
#include "Run/Report/ReportCells.h"
#include "Run/Report/ReportFigures.h"
#include "Run/Report/ReportJson.h"
#include "Run/Report/ReportTable.h"
#include "Run/RunWarnings.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

namespace bonedecimate
{
namespace
{
/// For each triangle the index of its label in the list of names.
using NamedLabels = std::pair<CellsIn, std::vector<std::string>>;

std::optional<Labels> ToLabels(const std::optional<NamedLabels>& from)
{
  if (!from)
  {
    return {};
  }
  Labels labels;
  labels.Names = from->second;
  const CellsIn& indices = from->first;
  labels.OfTriangle.assign(indices.data(), indices.data() + indices.shape(0));
  return labels;
}

void AddReport(const Report& report, nb::dict& fields)
{
  const std::vector<ReportEntry> entries = ReportEntries(report);
  fields["entries"] = ToList(entries);
  fields["json"] = ReportJson(entries);
  const std::vector<ReportEntry> bound = BoundToSurface(entries);
  fields["entries_of_surface"] = ToList(bound);
  fields["json_of_surface"] = ReportJson(bound);
  fields["status"] = report.Status;
  fields["stop"] = report.Stop;
  fields["problem"] = InputMessage(report);
  fields["contradiction"] = ProofMessage(report);
  fields["rejected_edits"] = RejectedEdits(report);
}

nb::dict RunDecimation(const PointsIn& points, const TrianglesIn& triangles, const Options& options,
  bool single, bool origins, const std::optional<NumbersIn>& tolerances,
  const std::optional<CellsIn>& cells,
  const std::optional<std::pair<PointsIn, TrianglesIn>>& reference, nb::object progress,
  const std::optional<NamedLabels>& labels, const LabelMapSource* labelMap, RegionCache* prepared,
  const std::optional<NumbersIn>& edgeLengths, const LeftOutIn& leftOut)
{
  const std::optional<Labels> named = ToLabels(labels);
  const Surface surface = ToSurface(points, triangles);
  const Surface first = reference ? ToSurface(reference->first, reference->second) : Surface();
  const std::optional<std::vector<double>> numbers = ToNumbers(tolerances);
  const std::optional<std::vector<double>> lengths = ToNumbers(edgeLengths);
  RunInputs inputs = { single, origins };
  inputs.Tolerances = numbers ? &*numbers : nullptr;
  inputs.Reference = reference ? &first : nullptr;
  inputs.Labels = named ? &*named : nullptr;
  inputs.EdgeLengths = lengths ? &*lengths : nullptr;
  inputs.LabelMap = labelMap;
  inputs.Regions = prepared;
  const std::vector<LeftOutShape> shapes = ToLeftOut(leftOut);
  inputs.LeftOut = &shapes;
  Result result =
    Listener(std::move(progress))
      .Hear([&](const Monitor& monitor) { return Decimate(surface, options, monitor, inputs); });
  if (cells)
  {
    NameCells([&](std::size_t triangle) { return cells->data()[triangle]; }, result.Report);
  }
  return ToDict(std::move(result), surface, options.NumberOfThreads);
}
}

//------------------------------------------------------------------------------
nb::dict ToDict(Result&& result, const Surface& input, int threads)
{
  nb::dict fields;
  AddReport(result.Report, fields);
  fields["warnings"] = RunWarnings(input, result.Report, threads);
  fields["points"] = ToRows<double>(std::move(result.Surface.Points));
  fields["triangles"] = ToRows<Index>(std::move(result.Surface.Triangles));
  fields["distance"] = ToArray(std::move(result.Distance));
  fields["running_error"] = ToArray(std::move(result.RunningError));
  fields["point_count"] = ToArray(std::move(result.PointCount));
  fields["input_distance"] = ToArray(std::move(result.InputDistance));
  fields["error_bound"] = ToArray(std::move(result.ErrorBound));
  fields["input_error_bound"] = ToArray(std::move(result.InputErrorBound));
  SurfaceOrigins& origins = result.Origins;
  fields["nearest_triangle"] = ToArray(std::move(origins.NearestTriangle));
  fields["barycentric"] = ToRows<double>(std::move(origins.Barycentric));
  fields["nearest_point"] = ToArray(std::move(origins.NearestPoint));
  fields["triangle_at_centroid"] = ToArray(std::move(origins.TriangleAtCentroid));
  fields["output_point"] = ToArray(std::move(origins.OutputPoint));
  const std::size_t pairs = result.BoundaryLabels.size();
  fields["boundary_labels"] =
    ToArray<Index, BoundaryLabels>(std::move(result.BoundaryLabels), { pairs, 2 });
  return fields;
}

//------------------------------------------------------------------------------
void BindDecimate(nb::module_& module)
{
  nb::class_<RegionCache>(module, "PreparedSurface",
    "What runs with tolerances of 0 keep of their surface, so that the next one runs only the "
    "regions that are new.")
    .def(nb::init<>())
    .def(
      "release", &RegionCache::Release, "Frees the memory; a run that uses it frees it at its end.")
    .def_prop_ro("memory", &RegionCache::Bytes, "Approximate memory in use, bytes.");
  module.def(
    "triangle_checksum",
    [](const PointsIn& points, const TrianglesIn& triangles)
    { return TriangleChecksumText(TriangleChecksum(ToSurface(points, triangles))); },
    nb::arg("points"), nb::arg("triangles"),
    "As output.checksum of a report: of the triangles in any order, to the bit.");
  module.def("decimate", &RunDecimation, nb::arg("points"), nb::arg("triangles"),
    nb::arg("options"), nb::arg("single"), nb::arg("origins"), nb::arg("tolerances").none(),
    nb::arg("cells").none(), nb::arg("reference").none(), nb::arg("progress").none(),
    nb::arg("labels").none() = nb::none(), nb::arg("label_map").none() = nb::none(),
    nb::arg("prepared").none() = nb::none(), nb::arg("edge_lengths").none() = nb::none(),
    nb::arg("left_out") = LeftOutIn(),
    "One run; the keys of what it returns are the members of Result (Result.h) in lower case.");
}
}
