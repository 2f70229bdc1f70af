// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SeamLines.h
 * @brief The lines along which sheets meet: chains of sites, of which those between the ends may go one by one.
 *
 *     a seam runs through a site:   every copy lies on the border of its sheet, and all have the same two sites beside them there
 *     a line:                       sites that a seam runs through, and at both ends one that it does not run through
 *     a ring:                       starts and ends at its least site
 *
 * Sites never move, so that what went lies between two sites that are left, in the order in which it came.
 */
#ifndef BoneDecimate_Core_Mesh_SeamLines_h
#define BoneDecimate_Core_Mesh_SeamLines_h

#include "HalfEdgeMesh.h"

#include <array>
#include <limits>
#include <vector>

namespace bonedecimate
{
/// The sites next to v along the border of its sheet, the lesser first; None where it is not on one.
std::array<Index, 2> BesideOnBorder(const HalfEdgeMesh& mesh, Index v);

/// Whether the seam at the site of v comes from one site and goes on to another, the same ones in every sheet.
bool SeamRunsThrough(const HalfEdgeMesh& mesh, Index v);

class SeamLines
{
public:
  /// @param mesh Before the first edit; frozen sites end a line.
  explicit SeamLines(const HalfEdgeMesh& mesh);

  /// Of a site on its line; ends of several lines have several.
  Index NumberOfPlaces() const { return static_cast<Index>(this->Sites.size()); }
  Index NumberOfEdges() const { return this->Edges; }
  Index NumberOfEdgesAtFirst() const { return this->EdgesAtFirst; }

  Index Site(Index place) const { return this->Sites[place]; }
  Index Before(Index place) const { return this->Neighbours[place][0]; }
  Index After(Index place) const { return this->Neighbours[place][1]; }
  /// Whether it is still there and no end.
  bool MayGo(Index place) const
  {
    return this->Before(place) != None && this->After(place) != None;
  }

  /// mm, the largest distance of what went, and of this one, to the edge that would take the place of its two. Infinite
  /// where that edge would have no length, or where something is farther away than `limitOf(site)`, mm.
  template <typename LimitOf>
  double Deviation(const HalfEdgeMesh& mesh, Index place, const LimitOf& limitOf) const;

  void Remove(Index place);

private:
  using Ends = std::array<Index, 2>;

  void AddLine(
    Index first, Index second, std::vector<char>& isOpen, const std::vector<Ends>& beside);
  double Distance(const HalfEdgeMesh& mesh, Index site, const Ends& segment) const;

  std::vector<Index> Sites;     // of each place, line after line
  std::vector<Ends> Neighbours; // places; None beyond ends and of what went
  Index Edges = 0;
  Index EdgesAtFirst = 0;
};

template <typename LimitOf>
double SeamLines::Deviation(const HalfEdgeMesh& mesh, Index place, const LimitOf& limitOf) const
{
  const Ends segment = { this->Site(this->Before(place)), this->Site(this->After(place)) };
  double most = segment[0] == segment[1] ? std::numeric_limits<double>::infinity() : 0.0;
  for (Index between = this->Before(place) + 1; between < this->After(place); ++between)
  {
    const double distance = this->Distance(mesh, this->Site(between), segment);
    const bool isFar = distance > limitOf(this->Site(between));
    most = isFar ? std::numeric_limits<double>::infinity() : std::max(most, distance);
  }
  return most;
}
}

#endif
