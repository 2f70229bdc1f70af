// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneDiagnostics
 * @brief   find defects of a surface before it is processed
 *
 * Takes triangles, strips or polygons in millimeters and passes them on as they are. The
 * diagnostics are a list: NaN and infinite points, ids out of range, repeated corners, triangles
 * without area, duplicates and backs of other triangles, unused and equal points, edges and points
 * that are not manifold, inconsistent orientation, open boundaries, points that nearly touch
 * another boundary (with the distance over which they would have to be welded), components, a size
 * that is not that of a bone in millimeters. Nothing is repaired.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneDiagnostics_h
#define vtkBoneDiagnostics_h

#include "vtkBoneAlgorithm.h"
#include "vtkFiltersBoneDecimateModule.h" // for export macro

#include <memory> // for std::unique_ptr
#include <string> // for words and sentences

class vtkIdList;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneDiagnostics : public vtkBoneAlgorithm
{
public:
  static vtkBoneDiagnostics* New();
  vtkTypeMacro(vtkBoneDiagnostics, vtkBoneAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Number of diagnostics of the last update; 0 after one that failed. Diagnostics are numbered
   * from 0; for other numbers the getters return an empty text, 0 or NaN.
   */
  int GetNumberOfDiagnostics() const;

  /**
   * Whether vtkBoneDecimate accepts the surface: nothing was found that it rejects. False before
   * the first update and after one that failed.
   */
  bool IsUsable() const;

  /**
   * The kind in one word: "non_manifold_edges".
   */
  std::string GetWord(int diagnostic) const;

  /**
   * What the kind means, as a sentence.
   */
  std::string GetSentence(int diagnostic) const;

  /**
   * What decimation does about it: "note" (nothing is wrong), "kept" (it stays as it is), "cleaned"
   * (merged or left out, and counted) or "rejected".
   */
  std::string GetSeverity(int diagnostic) const;

  /**
   * How many there are.
   */
  vtkIdType GetCount(int diagnostic) const;

  /**
   * mm: of "unwelded_points" the distance over which they would have to be welded, of "odd_size"
   * the diagonal of the bounding box. NaN for all others.
   */
  double GetLength(int diagnostic) const;

  /**
   * What GetFirstIds returns ids of: "point", "cell" or nothing.
   */
  std::string GetIdsOf(int diagnostic) const;

  /**
   * At most eight ids of the input, ascending.
   */
  void GetFirstIds(int diagnostic, vtkIdList* ids) const;

  ///@{
  /**
   * What of the last input is no surface to be decimated and proved: polygons without a triangle,
   * lines, vertices, and what the reader of its file left out. Its kind in one word ("lines"), how
   * many there are, and a sentence.
   */
  int GetNumberOfLeftOut() const;
  std::string GetLeftOutKind(int entry) const;
  vtkIdType GetLeftOutCount(int entry) const;
  std::string GetLeftOutSentence(int entry) const;
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024; 0, the default, is one per processor. The diagnostics do not depend
   * on it. Other numbers are an error event; the value before stays, and updates fail until there
   * is a valid one.
   */
  void SetNumberOfThreads(int threads);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

protected:
  vtkBoneDiagnostics();
  ~vtkBoneDiagnostics() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneDiagnostics(const vtkBoneDiagnostics&) = delete;
  void operator=(const vtkBoneDiagnostics&) = delete;

  struct Internals;

  const Internals& Last() const;

  int NumberOfThreads = 0;
  std::unique_ptr<Internals> Internal;
};

#endif
