// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertifyRun.h
 * @brief One certificate: reads the surfaces, compares them, writes and prints what was found.
 *
 *     Read             both surfaces, or a volume and a surface, in the axes of the reference
 *     CompareVoxels    with the label map, if there is one
 *     Compare          proved bounds of the distance, if there is a reference
 *     Write, Tell      JSON and page; lines for the terminal
 */
#ifndef BoneDecimate_Applications_CertifyRun_h
#define BoneDecimate_Applications_CertifyRun_h

#include "Certify.h"
#include "Files/StagedFile.h"
#include "VoxelCertificate.h"

#include "vtkBoneSurfaceDistance.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

namespace bonedecimate
{
class CertifyRun
{
public:
  explicit CertifyRun(const CertifyArguments& arguments);
  /// @throws Failure(ExitCode::InputRejected)
  void Read();

  /// Everything found, as JSON.
  std::string Json() const;
  /// After an interruption it leaves the bounds proved so far.
  void Compare();
  /// After Compare(). Interrupted, there are no counts.
  void CompareVoxels();
  /// Makes sure before the work that the outputs can be written.
  void Reserve();
  void Write();
  void Tell();

  /// Bounds of the distance and whether the tolerance is kept, in a line.
  std::string Line() const;
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }
  /// Interrupted if the comparison was stopped.
  ExitCode Code() const;

private:
  /// What the progress shows; empty before the first bounds.
  std::string BoundsSoFar() const;
  /// The page and its picture.
  void WritePage(StagedFile& page, StagedFile& picture);
  void TellDistance() const;
  void ReadReference();
  void ReadScan(const std::string& file);

  /// The result as it was read, turned if its file says that its axes are others.
  /// @param frame "LPS" or "RAS"; empty: not known. @param owner Whose frame it is.
  vtkSmartPointer<vtkPolyData> InFrame(const std::string& frame, const std::string& owner);

  /// Empty if there is no such entry.
  std::string LeftOut(int entry) const;

  /// Whether all that was left out is known to be within the tolerance.
  bool CoversWhatWasLeftOut() const;
  double Value(const std::string& name) const { return this->Filter->GetReportValue(name); }

  /// Where the bounds of that path are reached; empty if they are of nothing.
  std::string PositionText(const std::string& path) const;
  void TellDirection(const std::string& path, const std::string& words) const;

  /// The distance of open boundaries if it is larger than that of the surfaces.
  std::string FartherBoundary() const;

  /// Before the tolerance.
  std::string StatusText() const;

  /// What a proof of the tolerance does not cover; empty without one.
  std::string Reservations() const;
  void TellStatus() const;

  const CertifyArguments& Requested;
  std::vector<std::string> Warnings;
  std::string Frame; // of the reference, "LPS" or "RAS"; empty: not known
  vtkSmartPointer<vtkPolyData> ResultAsRead;
  vtkSmartPointer<vtkPolyData> Result; // in the frame of the reference
  std::string ReportOfResult;          // what it proves, as its file says
  vtkNew<vtkBoneSurfaceDistance> Filter;
  std::optional<VoxelCertificate> Voxels;
  bool WereVoxelsStopped = false;
  std::optional<StagedFile> Page;
  std::optional<StagedFile> Certificate; // as JSON
};
}

#endif
