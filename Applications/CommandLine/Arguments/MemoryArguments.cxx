// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MemoryArguments.h"

#include "Arguments.h"
#include "Base/Text.h"
#include "ExitCode.h"
#include "FlagNames.h"
#include "HelpFormatter.h"
#include "Partition/Slabs/SlabRun.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr std::int64_t MiB = std::int64_t(1) << 20;
constexpr std::int64_t LeastMemory = 256 * MiB;
/// Memory assumed for each triangle of the input of a run with a bound, more than is used
/// (Documentation/explanation/error-bound.md).
constexpr std::int64_t BytesOfATriangle = 1000;
/// Memory of the program and its libraries.
constexpr std::int64_t BytesOfTheProgram = 128 * MiB;
/// A run in slabs divides the rest between a slab, its voxels, and the result with what runs again.
constexpr std::int64_t PartsOfMemory = 8;
constexpr std::int64_t PartsOfASlab = 4;
constexpr std::int64_t LeastTriangles = 20000;

}

std::string MiBText(std::int64_t bytes)
{
  return std::to_string((bytes + MiB - 1) / MiB) + " MiB";
}

std::optional<std::int64_t> ParseMemory(const std::string& text)
{
  const std::string units = "kmgt";
  const std::size_t unit = text.empty() ? std::string::npos : units.find(LowerCase(text).back());
  const std::optional<double> number =
    unit == std::string::npos ? std::nullopt : ParseFinite(text.substr(0, text.size() - 1));
  const double bytes = number ? std::ldexp(*number, 10 * (static_cast<int>(unit) + 1)) : 0.0;
  constexpr double most = 1e18;
  return bytes >= static_cast<double>(LeastMemory) && bytes <= most
    ? std::optional<std::int64_t>(static_cast<std::int64_t>(bytes))
    : std::nullopt;
}

namespace
{
void AddMemoryOption(CLI::App& app, const std::string& flag,
  const std::function<void(const std::string& text)>& take, const std::string& help)
{
  app.add_option_function<std::string>(flag, take, WrappedHelp(help))
    ->type_name("SIZE")
    ->check(CLI::Validator(
      [](std::string& text)
      {
        return ParseMemory(text) ? std::string()
                                 : "takes a size of at least 256M such as 4G, not '" + text + "'";
      },
      ""));
}

}

void AddMemory(CLI::App& app, Arguments& arguments)
{
  AddMemoryOption(
    app, "--memory",
    [&arguments](const std::string& text)
    {
      arguments.Memory = *ParseMemory(text);
      arguments.Given["memory"] = text;
    },
    "With --iso or --segments: the memory that the run may use, such as 4G (K, M, G and T are "
    "powers of 1024; at least 256M). A volume that needs more is processed in slabs, "
    "within the same largest error of the whole surface. Takes no numbers of triangles, "
    "smoothing, pruning, filled cavities, regions, references or pictures.");
}

void AddMemoryLimit(CLI::App& app, Arguments& arguments)
{
  AddMemoryOption(
    app, "--memory-limit",
    [&arguments](const std::string& text) { arguments.MemoryLimit = *ParseMemory(text); },
    "Many bones: an input that needs more memory, such as 8G, is stopped and has failed. Default: "
    "no limit.");
}

void CheckMemory(const Arguments& arguments)
{
  if (arguments.Memory == 0)
  {
    return;
  }
  Options options = arguments.Options;
  // not known before the volume is read
  options.VoxelSize = options.VoxelSize > 0.0 ? options.VoxelSize : 1.0;
  const SlabRun run(options, {});
  if (run.Status() != SlabStatus::Good)
  {
    throw Failure(ExitCode::Usage, "--memory: " + WithFlags(run.Message()));
  }
}

SlabPlan PlanSlabs(const SlabSource::Extent& volume, std::int64_t memory)
{
  const std::int64_t layer = volume.VoxelBytes / volume.Layers;
  const std::int64_t reader = volume.IsReadWhole ? volume.VoxelBytes : layer;
  const std::int64_t rest = memory - BytesOfTheProgram - reader;
  SlabPlan plan;
  plan.IsWhole = volume.Triangles * BytesOfATriangle + volume.VoxelBytes <= rest;
  plan.Triangles = rest / PartsOfMemory * PartsOfASlab / BytesOfATriangle;
  plan.VoxelBytes = rest / PartsOfMemory;
  const std::int64_t least = BytesOfTheProgram + reader +
    PartsOfMemory * std::max(2 * layer, LeastTriangles * BytesOfATriangle / PartsOfASlab);
  if (!plan.IsWhole && memory < least)
  {
    plan.Problem = "--memory is too small for it: " +
      std::string(volume.IsReadWhole
          ? "its format gives no single layers, so that all voxels are in memory, and"
          : "the least slab") +
      " needs " + MiBText(least);
  }
  return plan;
}
}
