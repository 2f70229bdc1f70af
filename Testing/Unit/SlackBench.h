// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SlackBench.h
 * @brief A surface that the sweep has simplified as far as its error allows, for tests of what
 * comes after.
 */
#ifndef BoneDecimate_Testing_SlackBench_h
#define BoneDecimate_Testing_SlackBench_h

#include "Decimate/Schedule/BucketSweep.h"
#include "Decimate/Stages/SlackFit.h"
#include "GuardedEditor.h"
#include "Proof/Certificate/Certificate.h"
#include "Proof/Reference/OriginalHints.h"
#include "Proof/Reference/Samples.h"
#include "Runs.h"

#include <vector>

namespace bonedecimate::testsupport
{
constexpr double Limit = 0.3; // mm, the error of most tests
inline const Monitor Always = [](double) { return true; };

/// A sphere of 10 mm that the sweep has simplified as far as the error allows.
struct Bench
{
  explicit Bench(double error = Limit, const Surface& surface = Icosphere(3, 10.0))
    : Cleaned(Clean(surface, true))
    , MeshEditor(this->Cleaned, Guarded(error))
    , Fit(this->MeshEditor.Original().BoundedMesh(), false, Limits(error))
    , Back(this->MeshEditor.Original().BoundedMesh())
  {
    BucketSweep(this->MeshEditor, 1).Run({ 0, 0.0 }, Always);
    this->Back.Restart(this->Mesh(), 1, Always);
    this->Fit.Distribute(this->Mesh(), this->MeshEditor.Original().CurrentOfInitial(), 1, Always);
    this->MeshEditor.PrepareCollapses(1);
  }

  std::vector<float> Limits(double error) const
  {
    return std::vector<float>(this->Cleaned.Surface.Points.size(), static_cast<float>(error));
  }

  const HalfEdgeMesh& Mesh() const { return this->MeshEditor.Mesh(); }

  /// The faces of a vertex, with their samples.
  std::vector<FaceId> Gather(VertexId vertex, SlackFit& slack) const
  {
    std::vector<FaceId> faces;
    slack.Clear();
    for (const HalfEdgeId h : this->Mesh().OutgoingOf(vertex))
    {
      slack.AddSamples(HalfEdgeMesh::Face(h), faces.size());
      slack.AddFace(
        this->Mesh().Position(this->Mesh().Target(h)), this->Mesh().Position(this->Mesh().Apex(h)));
      faces.push_back(HalfEdgeMesh::Face(h));
    }
    return faces;
  }

  VertexId FirstVertex() const
  {
    VertexId v = 0;
    while (this->Mesh().Outgoing(v) == None)
    {
      v = v + 1;
    }
    return v;
  }

  ProofStatus Certified(double error) const
  {
    CertificateOptions options;
    options.Tolerance = error;
    options.TightBounds = false;
    options.NumberOfThreads = 1;
    return Certify(this->Cleaned.Surface, SurfaceOf(this->Mesh()), options).Proof;
  }

  CleanSurface Cleaned;
  Editor MeshEditor;
  Samples Fit;
  OriginalHints Back;
};

/// mm^3
inline double VolumeOf(const Surface& surface)
{
  double volume = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const std::vector<Vector3>& p = surface.Points;
    volume += p[t[0]].dot(p[t[1]].cross(p[t[2]])) / 6.0;
  }
  return volume;
}
}

#endif
