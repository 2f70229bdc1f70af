// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Arguments.h
 * @brief The arguments of a decimation.
 */
#ifndef BoneDecimate_Applications_Arguments_h
#define BoneDecimate_Applications_Arguments_h

#include "CliForward.h"
#include "LabelMapArguments.h"
#include "LengthUnit.h"
#include "Options/OptionTable.h"
#include "Regions.h"
#include "SegmentArguments.h"
#include "Settings/SettingsRecord.h"
#include "Terminal/ProgressDisplay.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// Every Of-th input of a batch, from number Number on.
struct ShardOfBatch
{
  std::size_t Number = 1; ///< From 1 on.
  std::size_t Of = 0;     ///< 0: all inputs.

  bool Has(std::size_t index) const
  {
    return this->Of == 0 || index % this->Of == this->Number - 1;
  }
};

struct Arguments
{
  std::vector<std::string> Inputs; ///< While parsing the output, too.
  std::string Output;              ///< A file for one bone, a folder for many.
  bonedecimate::Options Options;
  /// Options of the command line: flag without dashes and value.
  std::map<std::string, std::string> Given;
  std::optional<double> Iso; ///< Hounsfield value of the surface of a volume.
  SegmentArguments Segments;
  double FillVolume = 0.0;        ///< mm3, of cavities of volumes; 0: fills none.
  std::string ModelGrid = "auto"; ///< See ReadModelGridChoice().
  bool TakesLabels = false;       ///< Takes values that look like labels as intensities.
  std::vector<Region> Regions;
  LengthUnit Unit;            ///< Unit of coordinates in files of surfaces that name none.
  int PositionBits = 16;      ///< Bits of a coordinate in files that have a grid.
  bool CompressesGlb = false; ///< Outputs in glb.
  bool ColorsErrors = false;  ///< Whether vertex colors show the error.

  /// @name One bone only. @{
  std::vector<std::string> Also;
  std::string Reference; ///< What the input was made from; empty: nothing.
  LabelMapFile LabelMap;
  std::string Report;
  std::string Page;
  std::string Heatmap;
  std::string Picture;
  bool PictureIsRequired = true; ///< If it cannot be drawn, that is an error and not a warning.
  /// @}

  /// Extension of outputs in a folder; empty: that of each input, vtp for volumes.
  std::string Format;

  /// @name Many bones only. @{
  int Jobs = 0; ///< 0: not given.
  ShardOfBatch Shard;
  double TimeLimit = 0.0;       ///< Seconds for one input; 0: not limited.
  std::int64_t MemoryLimit = 0; ///< Bytes for one input; 0: not limited.
  bool Force = false;
  std::string Only; ///< A pattern of the names of files in input folders; empty: all.
  /// @}

  std::int64_t Memory = 0; ///< Bytes, of the run; 0: not limited.
  SettingsRecord Settings;
  bool Quiet = false;
  bool ShowsProgress = false; ///< Also where the error output is no terminal.
  bool HasTags = false;       ///< Called by 3D Slicer: progress in tags, every option given.
  bool ThesisForm = false;    ///< Always one bone.
  bool IsExplained = false;   ///< Instead of run.
};

/// How a run of one bone shows its progress.
Progress ProgressOf(const Arguments& arguments);

/// Adds the options of a decimation and its positional files.
void AddDecimateOptions(CLI::App& app, Arguments& arguments);

/// Adds those options of a decimation that smoothing alone has, and its positional files.
void AddSmoothOptions(CLI::App& app, Arguments& arguments);

/// Adds those options of a decimation that the form of the thesis has, too.
void AddThesisOptions(CLI::App& app, Arguments& arguments);

/// Receives an option of the table and its text, which was validated.
using OptionReceiver = std::function<void(const OptionInfo& info, const std::string& text)>;

/// Adds the flag of an option of the table, in its own form if it has one.
void AddOptionOfTable(CLI::App& app, const OptionInfo& info, const OptionReceiver& give);

/// Sets an option of the table from a text that was validated, and notes that it was given.
void GiveOption(Arguments& arguments, const OptionInfo& info, const std::string& text);

/// Completes the arguments after parsing: the last file is the output. @throws
/// Failure(ExitCode::Usage)
void TakeFiles(Arguments& arguments);

/// Whether there are many bones, and the output is a folder for them.
bool IsBatch(const Arguments& arguments);

/// Whether the extension is one that this program reads or writes.
bool IsNamedLikeFile(std::string path);

/// @throws Failure(ExitCode::Usage) if a new output folder would have a number as its name: the
///   value of an option that is not there.
void RequireFolderName(const std::string& output);

/**
 * What the parser cannot see: extensions, files that would overwrite each other, options of the
 * other form.
 * @throws Failure(ExitCode::Usage)
 */
void CheckArguments(const Arguments& arguments);

/// What the options that were given and have no effect need, a sentence each.
std::vector<std::string> IneffectiveSentences(const Arguments& arguments);

/// The files of a run of one bone: surfaces, report, page, heat map and picture; empty where one is
/// not requested.
std::vector<std::string> OutputsOf(const Arguments& arguments);

/// Options as on a command line, without those that change no result.
std::string OptionsText(const std::map<std::string, std::string>& given);
}

#endif
