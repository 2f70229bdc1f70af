// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneDecimateAlgorithm
 * @brief   superclass of the filters that run a decimation: the report of the last run
 *
 * The figures that are needed most have getters of their own. The whole report is one JSON text
 * (GetReportAsJson()), which the output carries in its field data, and a flat list of named entries
 * (GetReportValue()). Lengths are millimeters.
 *
 * @sa vtkBoneDecimate vtkBoneDecimateLevels vtkBoneErrorSearch
 */
#ifndef vtkBoneDecimateAlgorithm_h
#define vtkBoneDecimateAlgorithm_h

#include "vtkBoneAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for texts
#include <vector> // for warnings

class vtkAlgorithmOutput;
class vtkImageData;

namespace bonedecimate
{
struct LabelMapRequest;
struct Options;
}

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDecimateAlgorithm : public vtkBoneAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkBoneDecimateAlgorithm, vtkBoneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Why the last run ended.
  enum StopReasons
  {
    NOT_RUN = 0,
    TARGET_REACHED,
    ERROR_REACHED,
    ALREADY_SATISFIED,
    NOTHING_LEFT,
    ABORTED,
    HANDLES
  };

  /// What the certificate of the result says of the largest error.
  enum ProofStatuses
  {
    NO_PROOF = 0,
    PROVED,
    VIOLATED,
    UNDECIDED,
    PROOF_ABORTED ///< The run was aborted before its proof.
  };

  /// Whether the filter has an option of that name ("MaximumError").
  virtual bool HasOption(const std::string& name) const;

  /// Sets an option by its name from text: a number, "on" or "off", the name of a choice. An
  /// unknown name and a value outside the range are error events. @returns Whether the option has
  /// that value now.
  bool SetOptionFromText(const std::string& name, const std::string& text);

  /// Value of an option as SetOptionFromText() reads it; empty if the filter has no such option.
  std::string GetOptionAsText(const std::string& name) const;

  /// The label map from which the input was extracted: its active scalars are the labels of voxels,
  /// as points or cells. A surface that does not carry its voxel grid, such as that of another
  /// program, gets the grid of the map, for KeepVoxels and smoothing. The voxels of the result are
  /// compared with those of the map. A surface with another grid is an error. Default none.
  void SetLabelMapData(vtkImageData* map);

  /// Sets the label map as a connection, to the last input port. Default none.
  void SetLabelMapConnection(vtkAlgorithmOutput* map);

  ///@{
  /// The label of the label map that a surface without the array BoundaryLabels encloses. 0: the
  /// only label of the map that is not 0; a map with several is then an error. Default 0.
  void SetLabel(vtkTypeInt64 label);
  vtkGetMacro(Label, vtkTypeInt64);
  ///@}

  /// Why the last run ended: one of StopReasons; NOT_RUN before the first update. This and all
  /// figures of the report are again those before the first update after an update that failed, in
  /// this filter or before it.
  int GetStopReason() const;

  /// Why the last run ended, as a sentence.
  std::string GetStopReasonAsString() const;

  /// Proved upper bound of the distance between the input (or the reference) and the result, in
  /// both directions and between open boundaries, mm. NaN if nothing was proved, and before the
  /// first update.
  double GetProvedError() const;

  /// Whether the largest error is proved: one of ProofStatuses; NO_PROOF if none was requested, in
  /// mode Thesis, after an update that failed and before the first one.
  int GetProofStatus() const;

  /// The status of the proof in one word: "proved", "violated", "undecided", "aborted", "no_proof",
  /// or "not_requested" if GetProvedError() is proved without a largest error to compare it with.
  std::string GetProofStatusAsString() const;

  /// Largest distance between the input and the result that was found by samples, in both
  /// directions, mm: a lower bound of the true distance. NaN without MeasureDistances, and before
  /// the first update.
  double GetMeasuredError() const;

  /// Number of triangles of the input after cleaning and pruning; 0 before the first update.
  vtkIdType GetNumberOfInputTriangles() const;

  /// Number of triangles of the result of the last run; 0 before the first update.
  vtkIdType GetNumberOfOutputTriangles() const;

  /// Number of edits that the last run rejected, for all reasons together; 0 before the first
  /// update.
  vtkIdType GetNumberOfRejectedEdits() const;

  /// Number of edits that were rejected for one reason, named as in the report ("error_bound"); 0
  /// if the reason is unknown.
  vtkIdType GetNumberOfRejectedEdits(const std::string& reason) const;

  /// The whole report as JSON, objects within objects, as Documentation/report.schema.json
  /// describes it.
  std::string GetReportAsJson() const;

  /// Whether the report that a surface carries in its field data was made for this very surface:
  /// whether its triangles have the checksum of the report, to the bit and in any order. If not,
  /// what the report proves was proved of another surface.
  static bool HasReportOfItself(vtkPolyData* surface);

  /// The checksum of the triangles of a surface, "triangles:0123456789abcdef".
  static std::string GetTriangleChecksum(vtkPolyData* surface);

  /// Number of entries of the report as a flat list of named values ("output.triangles",
  /// "distance.output_to_input.max", ...).
  int GetNumberOfReportEntries() const;

  /// Name of an entry, 0 to GetNumberOfReportEntries() - 1; empty for other numbers.
  std::string GetReportEntryName(int entry) const;

  /// Unit of the entry of that name ("mm", "mm2", "s", ...); empty if it has none.
  std::string GetReportEntryUnit(const std::string& name) const;

  /// Value of an entry that is a number; NaN if the name is unknown or the entry is a text.
  double GetReportValue(const std::string& name) const;

  /// Value of an entry as text, numbers with all their digits; empty if the name is unknown.
  std::string GetReportText(const std::string& name) const;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkBoneDecimateAlgorithm();
  ~vtkBoneDecimateAlgorithm() override;

  /// Reports each sentence as a warning.
  void Warn(const std::vector<std::string>& sentences);

  /// What is wrong with a value that is in the range of its option, in one sentence; empty if
  /// nothing is.
  virtual std::string OptionProblem(
    const bonedecimate::Options& changed, const std::string& name) const;

  /**
   * Why the first option in use cannot be followed by a run of these kinds, in one sentence; empty
   * if all can.
   * @param kinds Names of rows of the core's table (RunKinds.h).  @param alsoUsed Options whose
   *   values do not tell that they are.
   */
  std::string FindUnsupportedOption(
    const std::vector<std::string>& kinds, const std::vector<std::string>& alsoUsed) const;

  /// Called before each run, so that no figure of the last one outlives its surface if this one
  /// fails.
  virtual void ForgetReport();

  /// An option has another value now.
  virtual void OptionChanged(const std::string& name);

  /// The input port of the label map, the last one. Called by constructors after they have set the
  /// number of the others.
  void AddLabelMapPort();

  bonedecimate::LabelMapRequest GetLabelMapRequest(vtkInformationVector** inputs) const;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  struct RunState;
  std::unique_ptr<RunState> State;

private:
  vtkBoneDecimateAlgorithm(const vtkBoneDecimateAlgorithm&) = delete;
  void operator=(const vtkBoneDecimateAlgorithm&) = delete;

  const RunState& Last() const;

  vtkTypeInt64 Label = 0;
  int LabelMapPort = -1;
};

#endif
