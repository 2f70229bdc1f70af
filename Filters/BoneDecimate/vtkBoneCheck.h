// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoneCheck
 * @brief   find what is odd about a surface before anything is done with it
 *
 * Takes triangles, strips or polygons in millimetres and passes them on as they are. What was found is a list: NaN and
 * infinite points, ids out of range, repeated corners, triangles without area, duplicates and backs of other triangles,
 * unused and equal points, edges and points that are not manifold, inconsistent orientation, open borders, points that
 * nearly touch another border (with the distance over which they would have to be welded), components, a size that is
 * not that of a bone in millimetres. Nothing is repaired.
 *
 * @sa vtkBoneDecimate
 */
#ifndef vtkBoneCheck_h
#define vtkBoneCheck_h

#include "vtkFiltersBoneDecimateModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for words and sentences

class vtkIdList;

class VTKFILTERSBONEDECIMATE_EXPORT vtkBoneCheck : public vtkPolyDataAlgorithm
{
public:
  static vtkBoneCheck* New();
  vtkTypeMacro(vtkBoneCheck, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  vtkMTimeType GetMTime() override; // changes as long as there is a rejected value

  /**
   * Of the last update. Findings are numbered from 0; what has no such number is empty, 0 or NaN.
   */
  int GetNumberOfFindings() const;

  /**
   * Whether vtkBoneDecimate takes the surface: nothing that it refuses was found.
   */
  bool IsUsable() const;

  /**
   * The kind in one word: "non_manifold_edges".
   */
  std::string GetWord(int finding) const;

  /**
   * What the kind means, for people.
   */
  std::string GetSentence(int finding) const;

  /**
   * What decimation does about it: "note" (nothing is wrong), "kept" (it stays as it is), "cleaned" (merged or left out, and
   * counted) or "refused".
   */
  std::string GetSeverity(int finding) const;

  /**
   * How many there are.
   */
  vtkIdType GetCount(int finding) const;

  /**
   * mm: of "unwelded_points" the distance over which they would have to be welded, of "odd_size" the diagonal of the bounding
   * box. NaN for all others.
   */
  double GetLength(int finding) const;

  /**
   * What GetFirstIds returns ids of: "point", "cell" or nothing.
   */
  std::string GetIdsOf(int finding) const;

  /**
   * At most eight ids of the input, ascending.
   */
  void GetFirstIds(int finding, vtkIdList* ids) const;

  ///@{
  /**
   * Threads to use, 0 to 1024; 0, the default, is one per processor. The findings do not depend on it. Other numbers are an
   * error event; the value before stays, and updates fail until there is a valid one.
   */
  void SetNumberOfThreads(int threads);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  /**
   * What is wrong with the last value of a property ("NumberOfThreads"), in one sentence; empty if it was valid.
   */
  std::string GetRejectedValue(const std::string& property) const;

protected:
  vtkBoneCheck();
  ~vtkBoneCheck() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoneCheck(const vtkBoneCheck&) = delete;
  void operator=(const vtkBoneCheck&) = delete;

  struct Internals;

  int NumberOfThreads = 0;
  std::unique_ptr<Internals> Internal;
};

#endif
