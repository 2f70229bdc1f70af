// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Doctor.h"

#include "Geometry/TriangleGeometry.h"
#include "Mesh/BoneSize.h"
#include "Mesh/Cleaning.h"
#include "Mesh/EdgeMatching.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Statistics.h"
#include "NearBorders.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
class Examination
{
public:
  Examination(const Surface& surface, int threads)
    : Whole(surface)
    , Threads(threads)
  {
  }

  std::vector<Finding> Go()
  {
    this->LookAtPoints();
    this->LookAtTriangles();
    if (this->Findings.empty())
    {
      const CleanSurface clean = Clean(this->Whole, true, this->Threads);
      this->LookAtCorners(clean);
      this->LookAtUse();
      if (clean.Status == InputStatus::Good)
      {
        this->LookAtCopies(clean);
        this->LookAtEqualPoints(clean);
        this->LookAtEdges(clean);
        this->LookAtTheWhole(clean);
      }
    }
    std::sort(this->Findings.begin(), this->Findings.end(),
      [](const Finding& a, const Finding& b) { return a.Kind < b.Kind; });
    return std::move(this->Findings);
  }

private:
  /// Ids for which it is so, among 0 to count - 1.
  template <typename IsFound>
  void Look(FindingKind kind, std::size_t count, const IsFound& isFound)
  {
    Finding finding = { kind };
    for (std::size_t i = 0; i < count; ++i)
    {
      if (isFound(i))
      {
        this->Add(finding, static_cast<Index>(i));
      }
    }
    this->Keep(std::move(finding));
  }

  static void Add(Finding& finding, Index id)
  {
    ++finding.Count;
    if (finding.First.size() < FirstFindings)
    {
      finding.First.push_back(id);
    }
  }

  void Keep(Finding finding)
  {
    if (finding.Count > 0)
    {
      std::sort(finding.First.begin(), finding.First.end());
      this->Findings.push_back(std::move(finding));
    }
  }

  void LookAtPoints()
  {
    const std::vector<Vector3>& points = this->Whole.Points;
    this->Look(FindingKind::NonFinitePoints, points.size(),
      [&](std::size_t p) { return !points[p].allFinite(); });
    this->Look(FindingKind::HugePoints, points.size(),
      [&](std::size_t p) { return points[p].allFinite() && !IsUsable(points[p]); });
  }

  void LookAtTriangles()
  {
    const auto count = static_cast<Index>(this->Whole.Points.size());
    this->Look(FindingKind::IdsOutOfRange, this->Whole.Triangles.size(),
      [&](std::size_t t)
      {
        const Triangle& c = this->Whole.Triangles[t];
        return std::any_of(c.begin(), c.end(), [&](Index id) { return id < 0 || id >= count; });
      });
  }

  /// The corners, equal points taken for one; points that only such triangles use that have a corner twice keep their ids.
  static Triangle MergedCorners(const CleanSurface& clean, const Triangle& corners)
  {
    Triangle merged = corners;
    for (Index& corner : merged)
    {
      const Index point = clean.PointOfInput[static_cast<std::size_t>(corner)];
      corner = point == None ? -1 - corner : point;
    }
    return merged;
  }

  void LookAtCorners(const CleanSurface& clean)
  {
    const std::vector<Triangle>& triangles = this->Whole.Triangles;
    const auto place = [&](Index id) -> const Vector3&
    { return this->Whole.Points[static_cast<std::size_t>(id)]; };
    const auto repeats = [&](const Triangle& c) {
      return place(c[0]) == place(c[1]) || place(c[1]) == place(c[2]) || place(c[2]) == place(c[0]);
    };
    this->Look(FindingKind::RepeatedCorners, triangles.size(),
      [&](std::size_t t) { return repeats(triangles[t]); });
    this->Look(FindingKind::NoArea, triangles.size(),
      [&](std::size_t t)
      {
        const Triangle& c = triangles[t];
        const Vector3 origin = clean.Origin;
        return !repeats(c) &&
          AreaVector(place(c[0]) - origin, place(c[1]) - origin, place(c[2]) - origin).norm() ==
          0.0;
      });
  }

  /// A triangle as its sorted corners, on which side it looks, and its id.
  struct Copy
  {
    Triangle Corners;
    bool IsTurned;
    Index Id;

    bool operator<(const Copy& other) const
    {
      return std::tie(this->Corners, this->Id) < std::tie(other.Corners, other.Id);
    }
  };

  static Copy Sorted(Triangle corners, Index id)
  {
    bool isTurned = false;
    for (const auto& [a, b] : { std::pair(0U, 1U), std::pair(1U, 2U), std::pair(0U, 1U) })
    {
      if (corners[a] > corners[b])
      {
        std::swap(corners[a], corners[b]);
        isTurned = !isTurned;
      }
    }
    return { corners, isTurned, id };
  }

  void LookAtCopies(const CleanSurface& clean)
  {
    std::vector<Copy> copies;
    copies.reserve(this->Whole.Triangles.size());
    for (std::size_t t = 0; t < this->Whole.Triangles.size(); ++t)
    {
      copies.push_back(
        Sorted(MergedCorners(clean, this->Whole.Triangles[t]), static_cast<Index>(t)));
    }
    std::sort(copies.begin(), copies.end());
    Finding duplicates = { FindingKind::Duplicates };
    Finding opposites = { FindingKind::Opposites };
    for (std::size_t i = 1; i < copies.size(); ++i)
    {
      if (copies[i].Corners == copies[i - 1].Corners)
      {
        this->Add(
          copies[i].IsTurned == copies[i - 1].IsTurned ? duplicates : opposites, copies[i].Id);
      }
    }
    this->Keep(std::move(duplicates));
    this->Keep(std::move(opposites));
  }

  void LookAtUse()
  {
    std::vector<bool> isUsed(this->Whole.Points.size(), false);
    for (const Triangle& corners : this->Whole.Triangles)
    {
      for (const Index corner : corners)
      {
        isUsed[static_cast<std::size_t>(corner)] = true;
      }
    }
    this->Look(FindingKind::UnusedPoints, isUsed.size(), [&](std::size_t p) { return !isUsed[p]; });
  }

  void LookAtEqualPoints(const CleanSurface& clean)
  {
    this->Look(FindingKind::EqualPoints, clean.PointOfInput.size(),
      [&](std::size_t p)
      {
        const Index point = clean.PointOfInput[p];
        return point != None &&
          clean.InputPoint[static_cast<std::size_t>(point)] != static_cast<Index>(p);
      });
  }

  void LookAtEdges(const CleanSurface& clean)
  {
    const std::vector<Triangle>& triangles = clean.Surface.Triangles;
    const std::size_t points = clean.Surface.Points.size();
    const EdgeMatching matching(triangles, points, this->Threads);
    std::vector<Edge> odd;
    for (std::size_t h = 0; h < 4 * triangles.size(); ++h)
    {
      if (h % 4 < 3 && matching.Twins()[h] < 0)
      {
        const Triangle& c = triangles[h / 4];
        const Index from = c[h % 4];
        const Index to = c[(h % 4 + 1) % 3];
        odd.push_back({ std::minmax(from, to), from < to, clean.InputTriangle[h / 4] });
      }
    }
    std::vector<bool> isOdd(points, false);
    std::vector<std::array<Index, 2>> open;
    this->CountEdges(odd, isOdd, open);
    this->LookAtFans(clean, matching, isOdd);
    this->LookAtGaps(clean, open);
  }

  struct Edge
  {
    std::pair<Index, Index> Ends; // the lesser first
    bool Rises;                   // whether its triangle runs from the lesser to the greater
    Index Triangle;               // of the input
  };

  /// @param isOdd Of each point: whether one of its edges is not manifold or not consistent.
  void CountEdges(
    std::vector<Edge>& edges, std::vector<bool>& isOdd, std::vector<std::array<Index, 2>>& open)
  {
    std::stable_sort(
      edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Ends < b.Ends; });
    Finding nonManifold = { FindingKind::NonManifoldEdges };
    Finding inconsistent = { FindingKind::InconsistentEdges };
    Finding border = { FindingKind::OpenEdges };
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last)
    {
      while (last < edges.size() && edges[last].Ends == edges[first].Ends)
      {
        ++last;
      }
      const std::size_t count = last - first;
      this->Add(count == 1 ? border
          : count == 2     ? inconsistent
                           : nonManifold,
        edges[first].Triangle);
      const auto& [from, to] = edges[first].Ends;
      if (count == 1)
      {
        open.push_back({ from, to });
      }
      else
      {
        isOdd[static_cast<std::size_t>(from)] = isOdd[static_cast<std::size_t>(to)] = true;
      }
    }
    this->Keep(std::move(nonManifold));
    this->Keep(std::move(inconsistent));
    this->Keep(std::move(border));
  }

  void LookAtFans(
    const CleanSurface& clean, const EdgeMatching& matching, const std::vector<bool>& isOdd)
  {
    const Rings rings = matching.FindRings();
    Finding pinched = { FindingKind::PinchedPoints };
    for (std::size_t p = 0; p < isOdd.size(); ++p)
    {
      if (rings.Kinds[p] == VertexKind::Locked && !isOdd[p])
      {
        this->Add(pinched, clean.InputPoint[p]);
      }
    }
    this->Keep(std::move(pinched));
  }

  void LookAtGaps(const CleanSurface& clean, const std::vector<std::array<Index, 2>>& open)
  {
    const NearBorders near = FindNearBorders(clean.Surface.Points, open);
    Finding unwelded = { FindingKind::UnweldedPoints };
    for (const Index point : near.Points)
    {
      this->Add(unwelded, clean.InputPoint[static_cast<std::size_t>(point)]);
    }
    unwelded.Length = near.WeldingDistance;
    this->Keep(std::move(unwelded));
  }

  void LookAtTheWhole(const CleanSurface& clean)
  {
    Finding components = { FindingKind::Components };
    components.Count = FindComponents(clean.Surface).Count;
    this->Keep(std::move(components));
    Vector3 most = Vector3::Zero(); // the least corner is the origin
    for (const Vector3& p : clean.Surface.Points)
    {
      most = most.cwiseMax(p);
    }
    Finding size = { FindingKind::OddSize };
    size.Length = most.norm();
    size.Count = size.Length > 0.0 && !IsBoneSize(size.Length) ? 1 : 0;
    this->Keep(std::move(size));
  }

  const Surface& Whole;
  int Threads;
  std::vector<Finding> Findings;
};
}

const FindingInfo& InfoOf(FindingKind kind)
{
  static const std::array<FindingInfo, NumberOfFindingKinds> table = { {
    { "non_finite_points", "points are not finite", "point", Severity::Refused },
    { "huge_points", "points have a coordinate beyond 1e30", "point", Severity::Refused },
    { "ids_out_of_range", "triangles name a point that is not there", "triangle",
      Severity::Refused },
    { "repeated_corners", "triangles have the same corner twice", "triangle", Severity::Cleaned },
    { "no_area", "triangles have no area", "triangle", Severity::Cleaned },
    { "duplicates", "triangles repeat an earlier one", "triangle", Severity::Kept },
    { "opposites", "triangles are the back of an earlier one", "triangle", Severity::Kept },
    { "unused_points", "points are used by no triangle", "point", Severity::Cleaned },
    { "equal_points", "points lie where an earlier one does", "point", Severity::Cleaned },
    { "non_manifold_edges", "edges have three or more triangles", "triangle", Severity::Kept },
    { "inconsistent_edges", "edges have two triangles that look to different sides", "triangle",
      Severity::Kept },
    { "pinched_points", "points hold parts together that share no edge there", "point",
      Severity::Kept },
    { "open_edges", "edges have one triangle: open borders", "triangle", Severity::Note },
    { "unwelded_points", "points of a border lie nearly on another border", "point",
      Severity::Kept },
    { "components", "connected parts", "", Severity::Note },
    { "odd_size", "the size is not that of a bone in millimetres", "", Severity::Note },
  } };
  return table[static_cast<std::size_t>(kind)];
}

const char* SeverityWord(Severity severity)
{
  static const std::array<const char*, 4> words = { "note", "kept", "cleaned", "refused" };
  return words[static_cast<std::size_t>(severity)];
}

//------------------------------------------------------------------------------
std::vector<Finding> Examine(const Surface& surface, int threads)
{
  return Examination(surface, threads).Go();
}
}
