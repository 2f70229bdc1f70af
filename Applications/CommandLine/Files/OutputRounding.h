// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OutputRounding.h
 * @brief What the files of a run round, and how the run keeps its largest error in spite of it.
 *
 *     grid          the run itself rounds its points to the grid of the files (FileGrid.h)
 *     other unit    the run keeps a smaller error, and its bounds are widened (FileRounding.h)
 */
#ifndef BoneDecimate_Applications_OutputRounding_h
#define BoneDecimate_Applications_OutputRounding_h

#include "Arguments/Arguments.h"

#include "vtkBoneDecimate.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace bonedecimate
{
class OutputRounding
{
public:
  /// @param arguments Must outlive this object.
  explicit OutputRounding(const Arguments& arguments);

  /// @param input mm. @param inFile The input in the unit of its file; null: a volume.
  void SetInput(vtkPolyData* input, vtkPolyData* inFile);

  /// Sets the grid, or reduces the largest error by what writing rounds. @throws
  /// Failure(ExitCode::InputRejected)
  void Reserve(Options& options);

  /// What the run takes: tolerances are smaller by what writing rounds. @param input mm, with the
  /// array of tolerances.
  vtkSmartPointer<vtkPolyData> InputOfRun(vtkPolyData* input, const std::string& array) const;

  /// @param result mm, of the filter, with arrays that are added to it. @throws Failure
  void Apply(vtkPolyData* result, vtkBoneDecimate* filter);

  /// The input with its distances in the unit of its file.
  vtkSmartPointer<vtkPolyData> HeatmapOf(vtkBoneDecimate* filter, vtkPolyData* input) const;

  /// mm, with what is proved of the files.
  vtkPolyData* GetResult() const { return this->Result; }

  /// The result in the unit of files that do not name theirs.
  vtkPolyData* GetInFile() const { return this->InFile; }

  const LengthUnit& GetUnit() const { return this->Unit; }

  /// @name For the summary, a sentence each. @{
  const std::vector<std::string>& GetNotes() const { return this->Notes; }
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }
  /// @}

private:
  void ApplyGrid(vtkBoneDecimate* filter);

  const Arguments& Requested;
  const std::string& Path;
  LengthUnit Unit; // of the surfaces but the heat map
  vtkSmartPointer<vtkPolyData> Input;
  vtkSmartPointer<vtkPolyData> InputInFile; // null: a volume
  bool IsSingle = false;                    // the input's file
  bool WritesSingle = false;                // in another unit than millimeters
  double Rounding = 0.0;                    // mm, for rounding; 0 in millimeters
  double Error = 0.0; // mm, requested in another unit than millimeters; 0: none
  double Move = 0.0;  // mm, by rounding
  vtkSmartPointer<vtkPolyData> Result;
  vtkSmartPointer<vtkPolyData> InFile;
  std::vector<std::string> Notes;
  std::vector<std::string> Warnings;
};
}

#endif
