// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackFit.h
 * @brief How much of the error bound a fan of faces uses, and where its vertex should go to use
 * less.
 *
 *     ratio(point) = distance / limit there; where nothing limits, the largest limit anywhere
 *       stands in, or nothing would hold a vertex
 *     error = sum of  area ratio^16  over the samples of the original, each to its nearest face of
 *                                    the fan,
 *                                and over points on the fan, each to the original
 *     step:   the minimum of  sum of  area |ratio + gradient . x|^p  by Newton's method for p = 4,
 *                                                                    8, 16
 *
 * The exponent makes this a smooth form of the largest ratio: what is left below 1 is slack for
 * further edits. It only proposes edits; filters decide. A least-squares fit would lower the mean
 * and let the largest ratio rise.
 */
#ifndef BoneDecimate_Core_Decimate_Stages_SlackFit_h
#define BoneDecimate_Core_Decimate_Stages_SlackFit_h

#include "Decimate/Edit/Editor.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"

#include <vector>

namespace bonedecimate
{
class SlackFit
{
public:
  SlackFit(const Editor& editor, const Samples& samples, const OriginalHints& hints);

  struct Value
  {
    double Error = Infinity;    ///< Squares of the mesh's unit.
    double MaxRatio = Infinity; ///< The largest of all ratios.
    Index Hint = None;          ///< The original triangle near the vertex.
  };

  /// After an evaluation: for each sample, in which face of the fan it is.
  struct Member
  {
    Index Sample;
    std::size_t Slot;
    bool IsCounted;
  };

  /// Starts an empty fan.
  void Clear();
  /// The next face of the fan, counter-clockwise; the fan must close.
  void AddFace(const Vector3& second, const Vector3& third);
  /// The samples of a face of the mesh. Those that are farther from it than their limit do not
  /// count: the mesh is proved, so they belong to another face.  @param slot The face of the fan
  /// where their search starts.
  void AddSamples(FaceId face, std::size_t slot);

  /// What an evaluation reads: searches on the original are most of its time.
  enum class ErrorTerms
  {
    Samples, ///< Only the samples of the original.
    All
  };
  void SetTerms(ErrorTerms terms) { this->Terms = terms; }
  /// One sample that was a member of an evaluation.
  void AddMember(const Member& member) { this->SampleMembers.push_back(member); }
  /// With the vertex at x.
  /// @param hint An original triangle near x.
  /// @param enough An error at which the evaluation ends; the value is infinite then.
  Value Evaluate(const Vector3& x, Index hint, double enough = Infinity);
  /// Error of two faces at x, which have the edge from x to the second corner of the last one in
  /// common; other edges do not count.
  Value EvaluatePair(const Vector3& x, Index hint, double enough);
  /// The largest ratio of the samples of the original alone; infinite above that ratio.
  double MaxRatioOfSamples(const Vector3& x, double most);

  /// The nearest position of a fine grid. One step after the other would amplify the rounding of
  /// coordinates, which is another one at another distance from the origin.
  Vector3 OnGrid(const Vector3& x) const;

  /// Moves x by Step(), or by a part of it, if that lowers the error by more than a little.
  /// @param before The last evaluation, at x.  @return At the new x; infinite if x did not move.
  Value TryStep(Vector3& x, const Value& before);

  /// Moves x as long as that lowers the error by more than a little, that often at most.
  Value Improve(Vector3& x, Index hint, int times);

  const std::vector<Member>& Members() const { return this->SampleMembers; }
  std::size_t NumberOfFaces() const { return this->Spokes.size(); }

private:
  struct Spoke
  {
    Vector3 Second, Third; // mm, of a face
  };
  struct Row
  {
    double Weight;    // squares of the mesh's unit
    double Ratio;     // at the last evaluation
    Vector3 Gradient; // 1 / mm
  };
  /// From the vertex of the last evaluation, which was not ended, mm.
  Vector3 Step() const;
  void Build(const Vector3& x);
  bool AddSampleRows(double enough);
  bool AddFaceRows(const Vector3& x, double enough, std::size_t firstSpoke);
  PointOnMesh AddPointRow(const Vector3& p, Index hint, double fraction, double weight);
  void AddRow(double weight, double distance, double limit, const Vector3& perDistance);
  double LimitOver(Index triangle) const;
  Vector3 NewtonStep(const std::vector<Row>& rows, const Vector3& x, int exponent) const;

  const Editor& MeshEditor;
  const Samples& OriginalSamples;
  const OriginalHints& Hints;
  const BoundingTree& Tree; // of the original
  double Spacing;           // mm, of the points on the fan
  double Grid;              // mm
  ErrorTerms Terms = ErrorTerms::All;
  double Radius = 0.0;   // mm, the longest step
  double RingArea = 0.0; // squares of the mesh's unit
  std::vector<Spoke> Spokes;
  std::vector<TriangleFrame> Frames;
  std::vector<Member> SampleMembers;
  std::vector<Row> Rows;
  Value CurrentValue;
};
}

#endif
