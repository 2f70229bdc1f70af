// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Diagnostics.h"

#include "Geometry/TriangleGeometry.h"
#include "InsideOut.h"
#include "Mesh/BoneSize.h"
#include "Mesh/Cleaning.h"
#include "Mesh/EdgeMatching.h"
#include "Mesh/HalfEdgeMesh.h"
#include "Mesh/Statistics.h"
#include "NearBoundaries.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace bonedecimate
{
namespace
{
class DiagnosticRun
{
public:
  DiagnosticRun(const Surface& surface, int threads)
    : InputSurface(surface)
    , Threads(threads)
  {
  }

  std::vector<Diagnostic> Run()
  {
    this->CheckPoints();
    this->CheckTriangles();
    if (this->Diagnostics.empty())
    {
      const CleanSurface clean = Clean(this->InputSurface, true, this->Threads);
      this->CheckCorners(clean);
      this->CheckUse();
      if (clean.Status == InputStatus::Good)
      {
        this->CheckDuplicates(clean);
        this->CheckEqualPoints(clean);
        this->CheckEdges(clean);
        this->CheckSizeAndComponents(clean);
      }
    }
    std::sort(this->Diagnostics.begin(), this->Diagnostics.end(),
      [](const Diagnostic& a, const Diagnostic& b) { return a.Kind < b.Kind; });
    return std::move(this->Diagnostics);
  }

private:
  /// Adds a diagnostic with the ids below count for which the predicate holds.
  template <typename IsFound>
  void FindIds(DiagnosticKind kind, std::size_t count, const IsFound& isFound)
  {
    Diagnostic diagnostic = { kind };
    for (std::size_t i = 0; i < count; ++i)
    {
      if (isFound(i))
      {
        this->Add(diagnostic, static_cast<Index>(i));
      }
    }
    this->Keep(std::move(diagnostic));
  }

  static void Add(Diagnostic& diagnostic, Index id)
  {
    ++diagnostic.Count;
    if (diagnostic.First.size() < FirstDiagnostics)
    {
      diagnostic.First.push_back(id);
    }
  }

  void Keep(Diagnostic diagnostic)
  {
    if (diagnostic.Count > 0)
    {
      std::sort(diagnostic.First.begin(), diagnostic.First.end());
      this->Diagnostics.push_back(std::move(diagnostic));
    }
  }

  void CheckPoints()
  {
    const std::vector<Vector3>& points = this->InputSurface.Points;
    this->FindIds(DiagnosticKind::NonFinitePoints, points.size(),
      [&](std::size_t p) { return !points[p].allFinite(); });
    this->FindIds(DiagnosticKind::HugePoints, points.size(),
      [&](std::size_t p) { return points[p].allFinite() && !IsUsable(points[p]); });
  }

  void CheckTriangles()
  {
    const auto count = static_cast<Index>(this->InputSurface.Points.size());
    this->FindIds(DiagnosticKind::IdsOutOfRange, this->InputSurface.Triangles.size(),
      [&](std::size_t t)
      {
        const Triangle& c = this->InputSurface.Triangles[t];
        return std::any_of(c.begin(), c.end(), [&](Index id) { return id < 0 || id >= count; });
      });
  }

  /// The corners after merging equal points; points used only by triangles with a repeated corner
  /// keep their ids.
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

  void CheckCorners(const CleanSurface& clean)
  {
    const std::vector<Triangle>& triangles = this->InputSurface.Triangles;
    const auto position = [&](Index id) -> const Vector3&
    { return this->InputSurface.Points[static_cast<std::size_t>(id)]; };
    const auto repeats = [&](const Triangle& c)
    {
      return position(c[0]) == position(c[1]) || position(c[1]) == position(c[2]) ||
        position(c[2]) == position(c[0]);
    };
    this->FindIds(DiagnosticKind::RepeatedCorners, triangles.size(),
      [&](std::size_t t) { return repeats(triangles[t]); });
    this->FindIds(DiagnosticKind::NoArea, triangles.size(),
      [&](std::size_t t)
      {
        const Triangle& c = triangles[t];
        const Vector3 origin = clean.Origin;
        return !repeats(c) &&
          AreaVector(position(c[0]) - origin, position(c[1]) - origin, position(c[2]) - origin)
            .norm() == 0.0;
      });
  }

  /// A triangle as its sorted corners, its orientation, and its id.
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

  void CheckDuplicates(const CleanSurface& clean)
  {
    std::vector<Copy> copies;
    copies.reserve(this->InputSurface.Triangles.size());
    for (std::size_t t = 0; t < this->InputSurface.Triangles.size(); ++t)
    {
      copies.push_back(
        Sorted(MergedCorners(clean, this->InputSurface.Triangles[t]), static_cast<Index>(t)));
    }
    std::sort(copies.begin(), copies.end());
    Diagnostic duplicates = { DiagnosticKind::Duplicates };
    Diagnostic opposites = { DiagnosticKind::Opposites };
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

  void CheckUse()
  {
    std::vector<bool> isUsed(this->InputSurface.Points.size(), false);
    for (const Triangle& corners : this->InputSurface.Triangles)
    {
      for (const Index corner : corners)
      {
        isUsed[static_cast<std::size_t>(corner)] = true;
      }
    }
    this->FindIds(
      DiagnosticKind::UnusedPoints, isUsed.size(), [&](std::size_t p) { return !isUsed[p]; });
  }

  void CheckEqualPoints(const CleanSurface& clean)
  {
    this->FindIds(DiagnosticKind::EqualPoints, clean.PointOfInput.size(),
      [&](std::size_t p)
      {
        const Index point = clean.PointOfInput[p];
        return point != None &&
          clean.InputPoint[static_cast<std::size_t>(point)] != static_cast<Index>(p);
      });
  }

  void CheckEdges(const CleanSurface& clean)
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
        odd.push_back({ std::minmax(from, to), clean.InputTriangle[h / 4] });
      }
    }
    this->CheckOrientation(clean, odd);
    std::vector<bool> isOdd(points, false);
    std::vector<std::array<Index, 2>> open;
    this->CountEdges(odd, isOdd, open);
    this->CheckFans(clean, matching, isOdd);
    this->CheckGaps(clean, open);
  }

  struct Edge
  {
    std::pair<Index, Index> Ends; // the lesser first
    Index Triangle;               // of the input
  };

  void CheckOrientation(const CleanSurface& clean, const std::vector<Edge>& odd)
  {
    std::vector<bool> isOpen(clean.Surface.Points.size(), false);
    for (const Edge& edge : odd)
    {
      isOpen[static_cast<std::size_t>(edge.Ends.first)] = true;
      isOpen[static_cast<std::size_t>(edge.Ends.second)] = true;
    }
    Diagnostic insideOut = { DiagnosticKind::InsideOut };
    for (const Index triangle : FindInsideOut(clean.Surface, isOpen))
    {
      this->Add(insideOut, clean.InputTriangle[static_cast<std::size_t>(triangle)]);
    }
    this->Keep(std::move(insideOut));
  }

  /// @param isOdd For each point: whether one of its edges is not manifold or not consistent.
  void CountEdges(
    std::vector<Edge>& edges, std::vector<bool>& isOdd, std::vector<std::array<Index, 2>>& open)
  {
    std::stable_sort(
      edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Ends < b.Ends; });
    Diagnostic nonManifold = { DiagnosticKind::NonManifoldEdges };
    Diagnostic inconsistent = { DiagnosticKind::InconsistentEdges };
    Diagnostic boundary = { DiagnosticKind::OpenEdges };
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last)
    {
      while (last < edges.size() && edges[last].Ends == edges[first].Ends)
      {
        ++last;
      }
      const std::size_t count = last - first;
      this->Add(count == 1 ? boundary
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
    this->Keep(std::move(boundary));
  }

  void CheckFans(
    const CleanSurface& clean, const EdgeMatching& matching, const std::vector<bool>& isOdd)
  {
    const Rings rings = matching.FindRings();
    Diagnostic pinched = { DiagnosticKind::PinchedPoints };
    for (std::size_t p = 0; p < isOdd.size(); ++p)
    {
      if (rings.Constraints[p] == VertexConstraint::NonManifold && !isOdd[p])
      {
        this->Add(pinched, clean.InputPoint[p]);
      }
    }
    this->Keep(std::move(pinched));
  }

  void CheckGaps(const CleanSurface& clean, const std::vector<std::array<Index, 2>>& open)
  {
    const NearBoundaries near = FindNearBoundaries(clean.Surface.Points, open);
    Diagnostic unwelded = { DiagnosticKind::UnweldedPoints };
    for (const Index point : near.Points)
    {
      this->Add(unwelded, clean.InputPoint[static_cast<std::size_t>(point)]);
    }
    unwelded.Length = near.WeldingDistance;
    this->Keep(std::move(unwelded));
  }

  void CheckSizeAndComponents(const CleanSurface& clean)
  {
    Diagnostic components = { DiagnosticKind::Components };
    components.Count = FindComponents(clean.Surface).Count;
    this->Keep(std::move(components));
    Vector3 most = Vector3::Zero(); // the origin is the least corner of the box
    for (const Vector3& p : clean.Surface.Points)
    {
      most = most.cwiseMax(p);
    }
    Diagnostic size = { DiagnosticKind::OddSize };
    size.Length = most.norm();
    size.Count = size.Length > 0.0 && !IsBoneSize(size.Length) ? 1 : 0;
    this->Keep(std::move(size));
  }

  const Surface& InputSurface;
  int Threads;
  std::vector<Diagnostic> Diagnostics;
};
}

std::vector<Diagnostic> Diagnose(const Surface& surface, int threads)
{
  return DiagnosticRun(surface, threads).Run();
}
}
