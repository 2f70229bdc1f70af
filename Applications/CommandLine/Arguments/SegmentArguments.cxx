// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentArguments.h"

#include "Arguments.h"
#include "Base/Text.h"
#include "BoneVolume.h"
#include "CommonOptions.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Formats/SurfaceFormat.h"
#include "HelpFormatter.h"
#include "Labels/LabelTable.h"
#include "Labels/ModelGrid/ModelGridChoice.h"
#include "PlainText.h"
#include "Segments/SegmentOutput.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <system_error>

namespace bonedecimate
{
namespace
{
/// Error message for the value of --label-names; empty if it is valid.
std::string TableProblem(std::string& text)
{
  std::error_code error;
  if (LowerCase(text) == TotalSegmentatorWord)
  {
    text = TotalSegmentatorWord;
    return std::string();
  }
  return std::filesystem::exists(FilePath(text), error)
    ? std::string()
    : std::string("takes ") + TotalSegmentatorWord + " or a file with names (" +
      LabelTableExtensions + "); there is no file '" + text + "'";
}
}

void AddSegments(CLI::App& app, SegmentArguments& segments,
  const std::function<void(const std::string& flag, const std::string& text)>& given)
{
  app
    .add_option_function<std::string>(
      "--segments",
      [&segments, given](const std::string& text)
      {
        segments.Choice = text;
        given("segments", text);
      },
      WrappedHelp(
        "The input is a label map: take the surfaces of its segments, with the walls "
        "between them in common. all, or with commas in between labels, names, and bones, "
        "vertebrae, pelvis or skull, which choose by names. The output is a surface, a .vtm file, "
        "or a folder "
        "with a file for each segment, report, page and picture."))
    ->type_name("all|LABELS|NAMES")
    ->check(CLI::Validator([](std::string& text)
      { return text.empty() ? "takes all, or labels and names, not ''" : std::string(); },
      ""));
  app
    .add_option_function<std::string>(
      "--label-names",
      [&segments, given](const std::string& text)
      {
        segments.LabelNames = text;
        given("label-names", text);
      },
      WrappedHelp("With --segments: a file with the names of the labels, of nnU-Net "
                  "(dataset.json), BIDS (.tsv), 3D Slicer (.ctbl, .csv) or ITK-SNAP (.txt, "
                  ".label), or those of the bones of TotalSegmentator v2, task total. By default "
                  "names are those of the label map's header or of such a file beside it."))
    ->type_name("totalsegmentator|TABLE")
    ->check(CLI::Validator(TableProblem, ""));
}

void AddModelGrid(CLI::App& app, std::string& choice,
  const std::function<void(const std::string& flag, const std::string& text)>& given)
{
  app
    .add_option_function<std::string>(
      "--model-grid",
      [&choice, given](const std::string& text)
      {
        choice = text;
        given("model-grid", text);
      },
      WrappedHelp(
        "With --segments: surfaces, smoothing and voxels are those of the coarser map of a "
        "network, from whose grid the labels were copied to the voxels of the scan. auto, "
        "the default: if it is certain that they were; off: those of the file; MM: the "
        "spacing of the network, which has to fit."))
    ->type_name("auto|off|MM[,MM,MM]")
    ->check(CLI::Validator(
      [](std::string& text)
      {
        text = LowerCase(text);
        return ReadModelGridChoice(text).Problem;
      },
      ""));
}

void CheckSegments(const Arguments& arguments)
{
  if (!arguments.Segments.IsRequested() || IsBatch(arguments))
  {
    return;
  }
  RequireUsage(IsVolume(arguments.Inputs[0]),
    "--segments is for label maps; '" + arguments.Inputs[0] + "' is none: read are " +
      ReadVolumesText());
  const bool isFile = FindFormat(arguments.Output) != nullptr;
  RequireFolderName(arguments.Output);
  RequireUsage(isFile || !IsNamedLikeFile(arguments.Output),
    "the output '" + arguments.Output + "' needs one of the extensions " + SurfaceExtensions() +
      ", vtm, or none to become a folder");
  const std::string name = BaseName(arguments.Output);
  RequireUsage(!IsBlockFile(arguments.Output) || PlainText(name) == name,
    "the name '" + name + "' has characters that the XML of a .vtm file cannot hold");
  RequireUsage(arguments.Format.empty() || IsSegmentFolder(arguments),
    "--format is for output folders; '" + arguments.Output + "' has that of its extension");
}
}
