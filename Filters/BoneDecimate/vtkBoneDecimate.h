// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneDecimate
 * @brief   make a bone surface smaller, keep every fragment, report the error in millimeters
 *
 * Takes a surface as marching cubes leaves it (triangles, strips or polygons, points shared or not)
 * and returns one with fewer triangles, by edge collapses in an order that depends on the mode
 * (SetMode()). Coordinates are millimeters. No component of the input is removed or merged with
 * another, open boundaries move only along themselves, edges and vertices that are not manifold
 * stay as they are.
 *
 * Input port 0: the surface. Input port 1, optional: the reference, the surface that the input was
 * made from. With it MaximumError is proved and measured against the reference, also over several
 * runs one after the other. Input port 2, optional: the label map, from which the surface was
 * extracted (SetLabelMapData()).
 *
 * Output port 0: the smaller surface. Point data: the distance to the input surface, the error
 * recorded along the collapses, what is proved around each point (all mm) and how many input points
 * each point represents. Field data: the report as one JSON text, BoneDecimateReport, and its main
 * figures as arrays of their own: bonedecimate.stop_reason, .input.triangles, .output.triangles,
 * .output.components, .distance.output_to_input.{max, mean}, .distance.input_to_output.{max, mean},
 * .proof.sentence and .proof.if_unchanged.{status, upper}, as far as the report has them. A proof
 * belongs to one surface: that whose triangles have the report's output.checksum. Vertices and
 * lines pass through.
 * Output port 1: the input, with the distance of each of its points to the result when
 * MeasureInputDistances is on.
 *
 * Tolerances and labels are arrays of the input, chosen by their names (ToleranceArrayName,
 * LabelArrayName) or by SetInputArrayToProcess(): index 0 is the point array of the tolerances,
 * index 1 the cell or point array of the labels. A name that is not empty takes precedence over the
 * array of that index.
 *
 * Measuring the distances is about two fifths of the time of a run without a largest error, and a
 * tenth with one; MeasureDistancesOff() leaves it out, with the distances of the report and the
 * array of distances. The proof does not need it.
 *
 * A value outside its range (NaN and infinity always are) is an error event when it is set: the
 * property keeps its value, and updates fail with the same sentence until it gets a valid one.
 * GetErrorCode() says after an update whether it failed (ErrorCodes). There is a progress event
 * per percent. An aborted run leaves a valid surface, and the proof status PROOF_ABORTED if a proof
 * was requested.
 *
 * An input that cannot be used (NaN, an index out of range) is an error with an empty output and
 * the reason in the message; an empty one gives an empty output and no error.
 *
 * @sa vtkBoneTolerance vtkBoneSurfaceDistance vtkQuadricDecimation vtkDecimatePro
 * H. Brandao, Mesh Simplification and Smoothing for Bone Fragment Models, BSc thesis, Groningen
 * 2018.
 */
#ifndef vtkBoneDecimate_h
#define vtkBoneDecimate_h

#include "vtkBoneOutputOptions.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <memory> // for std::unique_ptr

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDecimate : public vtkBoneOutputOptions
{
public:
  static vtkBoneDecimate* New();
  vtkTypeMacro(vtkBoneDecimate, vtkBoneOutputOptions);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Indices of SetInputArrayToProcess().
  enum InputArrays
  {
    TOLERANCE_ARRAY = 0,
    LABEL_ARRAY = 1
  };

  /**
   * The original surface, if the input is itself a result. MaximumError, which must be set, is then
   * proved against it. Tolerances of points remain against the input. An input that is farther from
   * it than MaximumError is an error. Default none.
   */
  void SetReferenceData(vtkPolyData* reference);

  /// Sets the original surface as a connection, to the input port 1. Default none.
  void SetReferenceConnection(vtkAlgorithmOutput* reference);

  ///@{
  /**
   * Whether the filter keeps what it prepared of its input and the results of regions, so that the
   * next update with other tolerances runs only the regions that are new. Only updates that run
   * regions keep anything (Documentation/how-to/tolerance.md). No result depends on it. Off
   * releases the memory. Default on.
   */
  void SetKeepPrepared(bool keep);
  bool GetKeepPrepared() const;
  void KeepPreparedOn() { this->SetKeepPrepared(true); }
  void KeepPreparedOff() { this->SetKeepPrepared(false); }
  ///@}

  /// Releases what is kept, until the next update.
  void ReleasePrepared();

  /// Approximate memory of what is kept, bytes.
  vtkTypeInt64 GetPreparedMemory() const;

protected:
  vtkBoneDecimate();
  ~vtkBoneDecimate() override;

  /// Resets TargetReduction to its default, which other targets override: for classes that set
  /// every property.
  void ForgetTargetReduction();

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  class Internals; // how runs are made, of whole surfaces and of parts
  std::unique_ptr<Internals> Internal;

private:
  vtkBoneDecimate(const vtkBoneDecimate&) = delete;
  void operator=(const vtkBoneDecimate&) = delete;
};

#endif
