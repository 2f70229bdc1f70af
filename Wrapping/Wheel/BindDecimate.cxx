// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BindDecimate.h"

#include "Arrays.h"
#include "Bindings.h"
#include "Listener.h"
#include "ReportCells.h"
#include "ReportTable.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace bonedecimate
{
namespace
{
/// Of each triangle a place in the list of names.
using NamedLabels = std::pair<CellsIn, std::vector<std::string>>;

std::optional<Labels> ToLabels(const std::optional<NamedLabels>& from)
{
  if (!from)
  {
    return {};
  }
  Labels labels;
  labels.Names = from->second;
  const CellsIn& places = from->first;
  labels.OfTriangle.assign(places.data(), places.data() + places.shape(0));
  return labels;
}

void AddReport(const Report& report, nb::dict& answer)
{
  answer["entries"] = ToList(ReportEntries(report));
  answer["status"] = report.Status;
  answer["stop"] = report.Stop;
  answer["problem"] = InputMessage(report);
  answer["warnings"] = InputWarnings(report);
  answer["contradiction"] = ProofMessage(report);
}

nb::dict Run(const PointsIn& points, const TrianglesIn& triangles, const Options& options,
  bool single, bool origins, const std::optional<NumbersIn>& tolerances,
  const std::optional<CellsIn>& cells,
  const std::optional<std::pair<PointsIn, TrianglesIn>>& reference, nb::object progress,
  const std::optional<NamedLabels>& labels)
{
  const std::optional<Labels> named = ToLabels(labels);
  const Surface surface = ToSurface(points, triangles);
  const Surface first = reference ? ToSurface(reference->first, reference->second) : Surface();
  const std::optional<std::vector<double>> numbers = ToNumbers(tolerances);
  Companions companions = { single, origins };
  companions.Tolerances = numbers ? &*numbers : nullptr;
  companions.Reference = reference ? &first : nullptr;
  companions.Labels = named ? &*named : nullptr;
  Result result = Listener(std::move(progress))
                    .Hear([&](const Monitor& monitor)
                      { return Decimate(surface, options, monitor, companions); });
  if (cells)
  {
    NameCells([&](std::size_t triangle) { return cells->data()[triangle]; }, result.Report);
  }
  return ToDict(std::move(result));
}
}

//------------------------------------------------------------------------------
nb::dict ToDict(Result&& result)
{
  nb::dict answer;
  AddReport(result.Report, answer);
  answer["points"] = ToRows<double>(std::move(result.Surface.Points));
  answer["triangles"] = ToRows<Index>(std::move(result.Surface.Triangles));
  answer["distance"] = ToArray(std::move(result.Distance));
  answer["running_error"] = ToArray(std::move(result.RunningError));
  answer["point_count"] = ToArray(std::move(result.PointCount));
  answer["input_distance"] = ToArray(std::move(result.InputDistance));
  answer["error_bound"] = ToArray(std::move(result.ErrorBound));
  answer["input_error_bound"] = ToArray(std::move(result.InputErrorBound));
  SurfaceOrigins& origins = result.Origins;
  answer["nearest_triangle"] = ToArray(std::move(origins.NearestTriangle));
  answer["barycentric"] = ToRows<double>(std::move(origins.Barycentric));
  answer["nearest_point"] = ToArray(std::move(origins.NearestPoint));
  answer["triangle_at_centroid"] = ToArray(std::move(origins.TriangleAtCentroid));
  answer["output_point"] = ToArray(std::move(origins.OutputPoint));
  return answer;
}

//------------------------------------------------------------------------------
void BindDecimate(nb::module_& module)
{
  module.def("decimate", &Run, nb::arg("points"), nb::arg("triangles"), nb::arg("options"),
    nb::arg("single"), nb::arg("origins"), nb::arg("tolerances").none(), nb::arg("cells").none(),
    nb::arg("reference").none(), nb::arg("progress").none(), nb::arg("labels").none() = nb::none(),
    "One run; the keys of what it returns are those of Decimate.h.");
}
}
