// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Samples.h
 * @brief Sample points of the original surface, assigned to the faces of the current mesh.
 *
 * Each face of the current mesh has a list of the samples nearest to it. The lists are not
 * maintained during the collapse. Afterwards each sample starts in the fan of the vertex into which
 * a corner of its triangle was merged, and walks over neighboring faces while its distance
 * decreases:
 *
 *     Distribute     builds all lists after a collapse; samples that end far away
 *                    also try the fans of other corners
 *     Settle         every sample walks on from its face
 *     Take, Put      an edit reassigns the samples of the faces that it changed
 */
#ifndef BoneDecimate_Core_Proof_Reference_Samples_h
#define BoneDecimate_Core_Proof_Reference_Samples_h

#include "Base/Monitor.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Original.h"
#include "SurfaceWalk.h"

#include <vector>

namespace bonedecimate
{
class Samples
{
public:
  struct Sample
  {
    /// From the local origin, units of the mesh, so that single precision suits any scale.
    std::array<float, 3> Position;
    float Weight; ///< The area it represents, squares of that unit.
    float Limit;  ///< mm, how far the result may be from it; infinite without an error bound.
    Index Next;   ///< In the list of its face.
  };

  /// @param original The mesh before the first collapse; must outlive this object.
  /// @param mayBeThree Take three samples in each triangle if many faces remain. False: always one,
  ///   which suffices where every edit is proved.
  /// @param limits mm, of each vertex: how far the result may be from it. Empty: infinite.
  /// @param shapeWeight Averages::ShapeWeight.
  explicit Samples(const HalfEdgeMesh& original, bool mayBeThree = true,
    std::vector<float> limits = {}, double shapeWeight = 0.0);

  /// Both return false after an abort; the lists are unusable then.
  /// @param current For each original vertex, the vertex into which it was merged, or one near it.
  bool Distribute(const HalfEdgeMesh& mesh, const std::vector<Index>& current, int threads,
    const Monitor& monitor);
  bool Settle(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor);

  Index First(FaceId face) const { return this->FirstSamples[face]; }
  const Sample& operator[](Index sample) const { return this->SampleList[sample]; }
  /// mm from the local origin
  Vector3 SamplePosition(const Sample& sample) const
  {
    return { this->Unit * sample.Position[0], this->Unit * sample.Position[1],
      this->Unit * sample.Position[2] };
  }
  /// Averages after Distribute, and the weight of shapes against them.
  struct Averages
  {
    double Distance = 0.0;    ///< Root mean square over the samples, mm.
    double FaceArea = 0.0;    ///< Mean over the faces, squares of the unit.
    double ShapeWeight = 0.0; ///< Weight in SampledErrorCost.h; 0: distances alone count.
  };
  const Averages& MeanValues() const { return this->Means; }

  Index Count() const { return static_cast<Index>(this->SampleList.size()); }

  /// Empties the list of a face and returns its first sample. The caller has to put each sample
  /// into a list again.
  Index Take(FaceId face)
  {
    const Index first = this->FirstSamples[face];
    this->FirstSamples[face] = None;
    return first;
  }
  void Put(Index sample, FaceId face)
  {
    this->SampleList[sample].Next = this->FirstSamples[face];
    this->FirstSamples[face] = sample;
  }

  /// Redistributes the samples of these faces among them.
  /// @param members Each sample with the position of its new face, Slot.
  template <typename Members>
  void HandOver(const std::vector<Index>& faces, const Members& members)
  {
    for (const Index face : faces)
    {
      this->Take(face);
    }
    for (const auto& member : members)
    {
      this->Put(member.Sample, faces[member.Slot]);
    }
  }

  template <typename Visit>
  void VisitFace(FaceId face, Visit visit) const
  {
    for (Index s = this->FirstSamples[face]; s != None; s = this->SampleList[s].Next)
    {
      visit(this->SampleList[s]);
    }
  }

  /// mm, the largest finite limit; little more than 0 without any.
  float MaxLimit() const { return this->MaxFiniteLimit; }

private:
  using CurrentVertices = std::vector<Index>; // for each original vertex

  Index TriangleOf(Index id) const
  {
    return (id - this->OriginalMesh.NumberOfVertexSlots()) / this->PerFace;
  }
  Vector3 PositionOf(Index id) const;
  float LimitOf(Index id) const;
  PointOnMesh FindNear(const HalfEdgeMesh& mesh, const CurrentVertices& current, Index id) const;
  PointOnMesh FindFar(const HalfEdgeMesh& mesh, const CurrentVertices& current, Index id,
    const PointOnMesh& found) const;
  bool FindFaces(
    const HalfEdgeMesh& mesh, const CurrentVertices& current, int threads, const Monitor& monitor);
  bool SortByFace(Index faces, int threads, const Monitor& monitor);
  std::vector<float> Weights(double& all) const;

  const HalfEdgeMesh& OriginalMesh;
  double Unit; // mm
  Averages Means;
  bool MayBeThree;
  std::vector<float> Limits; // mm, of each vertex
  float MaxFiniteLimit;      // mm
  bool HasSameFaces = true;  // whether faces have the ids of original triangles
  Index PerFace = 1;         // samples inside each original triangle
  std::vector<Sample> SampleList;
  std::vector<Index> FacesOfSamples; // of each sample; valid only within Distribute and Settle
  std::vector<Index> FirstSamples;   // of each face
};
}

#endif
