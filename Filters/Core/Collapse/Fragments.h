// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Fragments.h
 * @brief The volume of every closed component, so that none is pressed flat or turned inside out.
 */
#ifndef BoneDecimate_Core_Collapse_Fragments_h
#define BoneDecimate_Core_Collapse_Fragments_h

#include "Mesh/HalfEdgeMesh.h"

#include <vector>

namespace bonedecimate
{
class Fragments
{
public:
  /// Volume changes of a worker that are not settled yet, mm^3; it meets few components.
  class Changes
  {
  public:
    double Of(Index component) const;
    void Add(Index component, double change);

  private:
    friend class Fragments;
    struct Change
    {
      Index Component;
      double Volume; // mm^3
    };
    std::vector<Change> List;
  };

  /// @param joined The surface of the mesh, its sheets joined.
  Fragments(const HalfEdgeMesh& mesh, const Surface& joined);

  /// Whether the component of v may change its volume by that much (mm^3). Open components and cavities of no volume may.
  /// What may still be lost is shared out evenly among `workers` who do not know of each other's changes.
  bool MayChange(Index v, double volumeChange, const Changes& pending, int workers) const;

  Index Count() const { return static_cast<Index>(this->Volumes.size()); }
  Index ComponentOf(Index v) const { return this->OfVertex[v]; }

  /// Takes a worker's changes over.
  void Settle(Changes& changes);

  /// Measures all volumes afresh and shares what closed fragments may still lose among their vertices, so that vertices
  /// may be edited at the same time without asking what the others do.
  void Share(const HalfEdgeMesh& mesh);

  /// Whether an edit at v may change the volume by that much (mm^3), within the share of v.
  bool ShareAllows(Index v, double volumeChange) const;

private:
  struct Volume
  {
    double AtFirst = 0.0; // mm^3, signed
    double Now = 0.0;
    double Share = 0.0; // mm^3, what an edit of one vertex may take away
    bool IsClosed = true;
  };
  std::vector<double> Measure(const HalfEdgeMesh& mesh) const;

  std::vector<Index> OfVertex;
  std::vector<Volume> Volumes;
};
}

#endif
