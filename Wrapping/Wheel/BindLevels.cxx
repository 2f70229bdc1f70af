// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "BindDecimate.h"
#include "Bindings.h"
#include "Listener.h"
#include "Run/Levels.h"

#include <nanobind/stl/unique_ptr.h>

#include <memory>

namespace bonedecimate
{
namespace
{
nb::tuple ToTuple(Level&& level)
{
  return nb::make_tuple(ToRows<double>(std::move(level.Surface.Points)),
    ToRows<Index>(std::move(level.Surface.Triangles)));
}

/// Nothing is recorded for an input that is rejected.
const Levels& Opened(const Levels& levels)
{
  if (!levels.IsOpen())
  {
    throw nb::value_error("there are no levels: nothing was recorded");
  }
  return levels;
}

/// The levels if that is one of them.
const Levels& WithLevel(const Levels& levels, Index collapses)
{
  if (collapses < 0 || collapses > Opened(levels).NumberOfCollapses())
  {
    throw nb::index_error("no such level");
  }
  return levels;
}

nb::tuple Record(const PointsIn& points, const TrianglesIn& triangles, const Options& options,
  bool single, const LeftOutIn& leftOut, nb::object progress)
{
  const Surface surface = ToSurface(points, triangles);
  const std::vector<LeftOutShape> shapes = ToLeftOut(leftOut);
  RunInputs inputs = { single };
  inputs.LeftOut = &shapes;
  auto levels = std::make_unique<Levels>();
  Result run = Listener(std::move(progress))
                 .Hear([&](const Monitor& monitor)
                   { return RecordLevels(surface, options, monitor, inputs, *levels); });
  return nb::make_tuple(
    ToDict(std::move(run), surface, options.NumberOfThreads), std::move(levels));
}

std::unique_ptr<Levels> Open(
  const PointsIn& points, const TrianglesIn& triangles, const nb::bytes& log, int threads)
{
  EditLog edits;
  LogStatus status = ReadLog(static_cast<const unsigned char*>(log.data()), log.size(), edits);
  auto levels = std::make_unique<Levels>();
  if (status == LogStatus::Good)
  {
    const Surface surface = ToSurface(points, triangles);
    const nb::gil_scoped_release release;
    status = levels->Open(surface, std::move(edits), threads);
  }
  if (status != LogStatus::Good)
  {
    throw nb::value_error(LogMessage(status).c_str());
  }
  return levels;
}

nb::tuple On(
  const Levels& levels, Index collapses, const PointsIn& points, const TrianglesIn& triangles)
{
  std::optional<Level> level =
    WithLevel(levels, collapses).AtOn(ToSurface(points, triangles), collapses);
  if (!level)
  {
    throw nb::value_error(
      "the other surface has other triangles, or points that are not finite or beyond 1e30 mm");
  }
  return ToTuple(std::move(*level));
}

nb::list Marks(const Levels& levels)
{
  nb::list marks;
  for (const LevelMark& mark : levels.Log().Marks)
  {
    marks.append(nb::make_tuple(mark.Triangles, mark.Largest, mark.Mean));
  }
  return marks;
}
}

//------------------------------------------------------------------------------
void BindLevels(nb::module_& module)
{
  nb::class_<Levels>(
    module, "Levels", "A recorded run; level n is what its first n collapses made.")
    .def_prop_ro("collapses",
      [](const Levels& levels) { return levels.IsOpen() ? levels.NumberOfCollapses() : 0; })
    .def(
      "by_triangles",
      [](const Levels& levels, Index triangles) { return Opened(levels).ByTriangles(triangles); },
      nb::arg("triangles"))
    .def(
      "by_error", [](const Levels& levels, double error) { return Opened(levels).ByError(error); },
      nb::arg("error"))
    .def(
      "triangles_at",
      [](const Levels& levels, Index level) { return WithLevel(levels, level).TrianglesAt(level); },
      nb::arg("level"))
    .def(
      "at",
      [](const Levels& levels, Index level) { return ToTuple(WithLevel(levels, level).At(level)); },
      nb::arg("level"))
    .def("on", &On, nb::arg("level"), nb::arg("points"), nb::arg("triangles"))
    .def_prop_ro(
      "is_single", [](const Levels& levels) { return levels.Log().IsSingle; }, "float32.")
    .def("marks", &Marks, "(triangles, largest and mean distance, mm) from fine to coarse.")
    .def("log",
      [](const Levels& levels)
      {
        const std::vector<unsigned char> bytes = WriteLog(levels.Log());
        return nb::bytes(bytes.data(), bytes.size());
      });
  module.def("record_levels", &Record, nb::arg("points"), nb::arg("triangles"), nb::arg("options"),
    nb::arg("single"), nb::arg("left_out"), nb::arg("progress").none(),
    "The run as decimate() has it, and its levels.");
  module.def("open_levels", &Open, nb::arg("points"), nb::arg("triangles"), nb::arg("log"),
    nb::arg("threads"), "Raises ValueError if the log is none, damaged or of another surface.");
}
}
