// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzLogs.cxx
 * @brief Fuzzes logs of levels, any bytes or recorded logs with any values: rejected, or every
 * level is a surface.
 *
 *     bytes:  one that selects the recording, one whether its checksum is corrected, one what
 *             follows:
 *             the whole file after its first eight bytes
 *             or changes of the recording, six bytes each: two for the offset, four for the value
 */
#include "Bytes.h"
#include "ForgedLog.h"
#include "Run/Levels.h"
#include "Shapes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

using namespace bonedecimate;
using namespace bonedecimate::testsupport;

namespace
{
using LogFile = std::vector<unsigned char>;

constexpr std::size_t MagicBytes = 8;

struct Recording
{
  bonedecimate::Surface Surface;
  LogFile File;
};

Recording Record(const Surface& surface, Mode mode, bool isSingle)
{
  Options options;
  options.Mode = mode;
  options.MeasureDistances = false;
  options.NumberOfThreads = 1;
  options.TargetNumberOfTriangles = 1;
  Levels levels;
  RecordLevels(surface, options, {}, { isSingle }, levels);
  return { surface, WriteLog(levels.Log()) };
}

/// Closed, open, not manifold; with patches and without.
const std::vector<Recording>& Recordings()
{
  static const std::vector<Recording> recordings = {
    Record(Icosphere(1, 10.0), Mode::Fast, true),
    Record(HeightField(6, 0.5, 1), Mode::Balanced, false),
    Record(ThreeLeavedBook(4), Mode::Fast, true),
    Record(HeightField(6, 0.5, 2), Mode::Thesis, true),
  };
  return recordings;
}

LogFile AnyFile(const Recording& recording, Bytes& bytes)
{
  const bool isForged = bytes.Switch();
  LogFile file = recording.File;
  if (bytes.Switch())
  {
    file.resize(MagicBytes);
    file.insert(file.end(), bytes.Rest(), bytes.Rest() + bytes.Count());
  }
  else
  {
    while (bytes.Count() >= 6)
    {
      const int high = bytes.Next();
      const auto offset = static_cast<std::size_t>(256 * high + bytes.Next());
      std::uint32_t value = 0;
      for (int k = 0; k < 4; ++k)
      {
        value = value * 256 + static_cast<std::uint32_t>(bytes.Next());
      }
      PutIndex(file, MagicBytes + offset % (file.size() - MagicBytes - 4), value);
    }
  }
  return isForged ? Forged(std::move(file)) : file;
}

void Demand(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
  }
}

void DemandLevel(const Level& level, Index triangles)
{
  const Surface& surface = level.Surface;
  Demand(static_cast<Index>(surface.Triangles.size()) == triangles, "another number of triangles");
  Demand(level.Vertices.size() == surface.Points.size(), "points without a vertex");
  Demand(std::all_of(surface.Points.begin(), surface.Points.end(),
           [](const Vector3& point) { return point.allFinite(); }),
    "a point is not finite");
  for (const Triangle& corners : surface.Triangles)
  {
    for (const Index corner : corners)
    {
      Demand(corner >= 0 && static_cast<std::size_t>(corner) < surface.Points.size(),
        "a corner is no point");
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  const Recording& recording =
    Recordings()[static_cast<std::size_t>(bytes.Below(static_cast<int>(Recordings().size())))];
  const LogFile file = AnyFile(recording, bytes);
  EditLog log;
  const LogStatus status = ReadLog(file.data(), file.size(), log);
  Demand(
    (status == LogStatus::Good) == LogMessage(status).empty(), "a rejection without a message");
  Levels levels;
  if (status != LogStatus::Good ||
    levels.Open(recording.Surface, std::move(log), 1) != LogStatus::Good)
  {
    return 0;
  }
  for (Index level = 0; level <= levels.NumberOfCollapses(); ++level)
  {
    DemandLevel(levels.At(level), levels.TrianglesAt(level));
  }
  levels.ByTriangles(1);
  levels.ByError(0.1);
  Demand(levels.AtOn(recording.Surface, levels.NumberOfCollapses()).has_value(),
    "a level does not go back onto its own surface");
  return 0;
}
