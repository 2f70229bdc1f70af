// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Samples.h
 * @brief Points of the original surface that travel with the faces of the current mesh.
 *
 * Every face of the current mesh knows the samples that lie nearest to it as a list; nothing is kept up during the
 * collapse. Afterwards each sample starts in the fan of the vertex that a corner of its triangle was merged into, and
 * walks over neighbouring faces while its distance falls:
 *
 *     Distribute     from nothing, after a collapse; those that end far away try the fans of other corners
 *     Settle         every sample walks on from its face
 *     Take, Put      an edit reassigns the samples of the few faces it changed
 */
#ifndef BoneDecimate_Core_Reference_Samples_h
#define BoneDecimate_Core_Reference_Samples_h

#include "Mesh/HalfEdgeMesh.h"
#include "Monitor.h"
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
    std::array<float, 3>
      Place;      ///< From the local origin, units of the mesh: no scale is too small or too large.
    float Weight; ///< The area it stands for, squares of that unit.
    Index Next;   ///< In the list of its face.
  };

  /// @param original The mesh before the first collapse, which must stay.
  /// @param mayBeThree Of each triangle, where many remain; else one: where every edit is proved they gain nothing.
  explicit Samples(const HalfEdgeMesh& original, bool mayBeThree = true);

  /// Both return false if the monitor said stop; then there is nothing to go on with.
  bool Distribute(
    const HalfEdgeMesh& mesh, const Original& merged, int threads, const Monitor& monitor);
  bool Settle(const HalfEdgeMesh& mesh, int threads, const Monitor& monitor);

  Index First(Index face) const { return this->Firsts[face]; }
  const Sample& operator[](Index sample) const { return this->All[sample]; }
  /// mm from the local origin
  Vector3 SamplePosition(const Sample& sample) const
  {
    return { this->Unit * sample.Place[0], this->Unit * sample.Place[1],
      this->Unit * sample.Place[2] };
  }
  /// What is usual, after Distribute.
  struct Usual
  {
    double Distance = 0.0; ///< Root mean square over the samples, mm.
    double FaceArea = 0.0; ///< Mean over the faces, squares of the unit.
  };
  const Usual& Spread() const { return this->Measured; }

  Index Count() const { return static_cast<Index>(this->All.size()); }

  /// Empties the list of the face and returns its first sample; whoever takes it puts each back somewhere.
  Index Take(Index face)
  {
    const Index first = this->Firsts[face];
    this->Firsts[face] = None;
    return first;
  }
  void Put(Index sample, Index face)
  {
    this->All[sample].Next = this->Firsts[face];
    this->Firsts[face] = sample;
  }

  template <typename Visit>
  void VisitFace(Index face, Visit visit) const
  {
    for (Index s = this->Firsts[face]; s != None; s = this->All[s].Next)
    {
      visit(this->All[s]);
    }
  }

private:
  using CurrentVertices = std::vector<Index>; // of each original vertex

  Index TriangleOf(Index id) const
  {
    return (id - this->Source.NumberOfVertexSlots()) / this->PerFace;
  }
  Vector3 PlaceOf(Index id) const;
  PlaceOnMesh FindNear(const HalfEdgeMesh& mesh, const CurrentVertices& current, Index id) const;
  PlaceOnMesh FindFar(const HalfEdgeMesh& mesh, const CurrentVertices& current, Index id,
    const PlaceOnMesh& found) const;
  bool FindFaces(
    const HalfEdgeMesh& mesh, const CurrentVertices& current, int threads, const Monitor& monitor);
  bool SortByFace(Index faces, int threads, const Monitor& monitor);
  std::vector<float> Weights(double& all) const;

  const HalfEdgeMesh& Source;
  double Unit; // mm
  Usual Measured;
  bool MayBeThree;
  Index PerFace = 1; // samples inside each original triangle
  std::vector<Sample> All;
  std::vector<Index> Faces;  // of each sample; valid only within Distribute and Settle
  std::vector<Index> Firsts; // of each face
};
}

#endif
