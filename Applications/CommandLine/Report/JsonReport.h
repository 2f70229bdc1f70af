// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JsonReport.h
 * @brief The report of one bone as JSON.
 */
#ifndef BoneDecimate_Applications_JsonReport_h
#define BoneDecimate_Applications_JsonReport_h

#include "Arguments/Arguments.h"
#include "Files/FileStamp.h"
#include "Geometry/Surface.h"
#include "Partition/Slabs/SlabRun.h"
#include "Segments/SegmentRecord.h"
#include "Segments/SegmentSurfaces.h"
#include "SurfaceExtents.h"

#include "vtkPolyData.h"

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
/// The map of a network that was extracted instead of that of the file.
struct ModelGridRecord
{
  std::string Sentence;
  std::array<double, 3> Spacing; ///< mm
  std::array<Index, 3> Dimensions;
  double Chance = 0.0;        ///< ModelGrid::Chance
  std::int64_t Different = 0; ///< Voxels of the file that are no copies.
  FileComparison OfFile = {};
};

/// What the report says beyond the filter's own. Names are base names: no folder reaches a report.
struct ReportSubject
{
  std::string Input;
  std::string Output;
  std::string Unit;             ///< Unit of the coordinates in input and output.
  std::string CoordinateSystem; ///< "LPS" or "RAS"; empty: not known.
  FileStamp InputStamp;         ///< From before the input was read.
  std::int64_t OutputBytes = 0;
  std::map<std::string, std::string> Given; ///< The options of the command line, by flag.
  SettingsRecord Settings;                  ///< Where some of the options are from.
  std::vector<std::string> Warnings;
  std::vector<std::string> Notes; ///< What was done as the user wants it, and what formats lack.
  /// Result of ProveWritten() for each surface that was written after it had been proved, by file.
  std::map<std::string, std::string> ProvedFiles;
  std::vector<SegmentRecord> Segments; ///< Segments of a label map.
  std::optional<ModelGridRecord> ModelGrid;
  SpeckFigures Specks;              ///< In the input of the run; none if they were not counted.
  std::optional<SlabFigures> Slabs; ///< Figures of a run in slabs.
  PiecesOfLabels Changed; ///< Changes of a volume before extraction; empty: none were requested.
  double SecondsRead = 0.0;
  double SecondsWrite = 0.0;
  double SecondsTotal = 0.0; ///< From the start to the written surface.
};

/// What is known of it before the input is read.
ReportSubject SubjectOf(
  const Arguments& arguments, const std::string& input, const std::string& output);

/**
 * The report in the field data of a result (output port 0 of vtkBoneDecimate), nested at the dots
 * of its names, with "units" of the entries that have one, and the subject as "files",
 * "command_line", "warnings", "notes" and "seconds".
 */
std::string ComposeJsonReport(vtkPolyData* result, const ReportSubject& subject);

/// What a certificate of the program is of. Files are named without their folder.
struct CertificateSubject
{
  std::string Reference; ///< Empty: none.
  std::string Result;
  std::string LabelMap;            ///< Empty: none.
  std::optional<double> Tolerance; ///< mm
  std::string ToleranceArray;      ///< Point array of the reference; empty: none.
  std::string Unit;                ///< Unit of the coordinates in the files of surfaces.
  nlohmann::ordered_json Voxels;   ///< "voxels"; null: not compared.
  std::vector<std::string> Warnings;
  /// What the report in the file of the result proves; empty: there is none.
  std::string ReportOfResult;
  SettingsRecord Settings;
  std::optional<double> Iso = {}; ///< HU, of the surface of a volume as the reference.
};

/// A certificate in the same way.
/// @param certificate vtkBoneSurfaceDistance::GetReportAsJson(); empty: distances were not proved.
std::string ComposeJsonCertificate(
  const std::string& certificate, const CertificateSubject& subject);

/// The text for a file. Bytes of names that are not UTF-8 do not prevent a report.
std::string JsonText(const nlohmann::ordered_json& json);

/// @throws Failure(ExitCode::CouldNotWrite)
void WriteJsonFile(const std::string& path, const nlohmann::ordered_json& json);

/**
 * The options of an earlier run, by flag (threads are not among them), if its report is of an input
 * of this name and its output still has the size it was written with; that of a folder are the
 * files of its segments. Nothing if there is no such report.
 */
std::optional<std::map<std::string, std::string>> OptionsOfReport(
  const std::string& reportFile, const std::string& outputFile, const std::string& inputFile);

/// Whether that report is of this version, the same input and the same options, too.
bool ReportMatches(
  const std::string& reportFile, const std::string& outputFile, const ReportSubject& subject);

/// Whether the output still has the size that its report says.
bool OutputMatches(const std::string& reportFile, const std::string& outputFile);
}

#endif
