// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackFit.h
 * @brief How much of the error bound a fan of faces uses, and where its vertex should move to use
 * less.
 *
 *     ratio(point) = distance / limit at the point; where nothing limits, the largest limit, so
 *                    that the vertex stays near
 *     error = sum of area ratio^16 over the samples of the original, each to its nearest face of
 *             the fan, and over points on the fan, each to the original
 *     step  = minimum of the sum of area |ratio + gradient . x|^p, by Newton's method for
 *             p = 4, 8, 16
 *
 * The high exponent makes the error a smooth form of the largest ratio. What is left below a ratio
 * of 1 is slack for further edits. This class only proposes edits; filters decide. A least-squares
 * fit would lower the mean but let the largest ratio rise.
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
    double MaxRatio = Infinity; ///< Largest ratio.
    Index Hint = None;          ///< An original triangle near the vertex.
  };

  /// A sample and the face of the fan that it belongs to, after an evaluation.
  struct Member
  {
    Index Sample;
    std::size_t Slot;
    bool IsCounted;
  };

  /// Starts an empty fan.
  void Clear();
  /// Adds the next face of the fan, counter-clockwise. The fan must close.
  void AddFace(const Vector3& second, const Vector3& third);
  /// Adds the samples of a face of the mesh. Samples farther from it than their limit do not count:
  /// the mesh is proved, so they belong to another face.
  /// @param slot The face of the fan where their search starts.
  void AddSamples(FaceId face, std::size_t slot);

  /// The terms of the error. Most of the time is spent on searches on the original for points on
  /// the fan.
  enum class ErrorTerms
  {
    Samples, ///< The samples of the original.
    All
  };
  void SetTerms(ErrorTerms terms) { this->Terms = terms; }
  /// Adds a sample that was a member of an earlier evaluation.
  void AddMember(const Member& member) { this->SampleMembers.push_back(member); }
  /// Evaluates the fan with the vertex at x.
  /// @param hint An original triangle near x.
  /// @param enough The error at which the evaluation ends; then the value is infinite.
  Value Evaluate(const Vector3& x, Index hint, double enough = Infinity);
  /// The error of two faces at x, which have the edge from x to the second corner of the last face
  /// in common. Other edges do not count.
  Value EvaluatePair(const Vector3& x, Index hint, double enough);
  /// The largest ratio of the samples alone; infinite if it exceeds maxRatio.
  double MaxRatioOfSamples(const Vector3& x, double maxRatio);

  /// The nearest position of a fine grid. Without it, repeated steps would amplify the rounding of
  /// coordinates, which depends on the distance from the origin.
  Vector3 OnGrid(const Vector3& x) const;

  /// Moves x by Step() or a part of it if this lowers the error by more than a little.
  /// @param before The last evaluation, at x.  @return The value at the new x; infinite if x did
  /// not move.
  Value TryStep(Vector3& x, const Value& before);

  /// Moves x as long as this lowers the error by more than a little, up to `times` times.
  Value Improve(Vector3& x, Index hint, int times);

  const std::vector<Member>& Members() const { return this->SampleMembers; }
  std::size_t NumberOfFaces() const { return this->Spokes.size(); }

private:
  struct Spoke
  {
    Vector3 Second, Third; // mm
  };
  struct Row
  {
    double Weight;    // squares of the mesh's unit
    double Ratio;     // at the last evaluation
    Vector3 Gradient; // 1 / mm
  };
  /// The step from the vertex of the last evaluation, mm. The evaluation must not have ended early.
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
  double MaxStep = 0.0;  // mm
  double RingArea = 0.0; // squares of the mesh's unit
  std::vector<Spoke> Spokes;
  std::vector<TriangleFrame> Frames;
  std::vector<Member> SampleMembers;
  std::vector<Row> Rows;
  Value CurrentValue;
};
}

#endif
