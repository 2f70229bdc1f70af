// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenBoundaries.h"

#include "Proof/Certificate/Certificate.h"

#include <algorithm>
#include <iterator>

namespace bonedecimate
{
namespace
{
using Edge = std::array<Index, 2>;

/// Ascending, once for each triangle.
std::vector<Edge> SortedEdges(const Surface& surface)
{
  std::vector<Edge> edges;
  edges.reserve(3 * surface.Triangles.size());
  for (const Triangle& c : surface.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      edges.push_back({ std::min(c[i], c[(i + 1) % 3]), std::max(c[i], c[(i + 1) % 3]) });
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Calls visit(element, count) for each group of equal elements.
template <typename T, typename Visit>
void ForEachGroup(const std::vector<T>& sorted, const Visit& visit)
{
  for (auto first = sorted.begin(); first != sorted.end();)
  {
    const auto last = std::find_if(first, sorted.end(), [&](const T& e) { return e != *first; });
    visit(*first, static_cast<std::size_t>(last - first));
    first = last;
  }
}

void AddSegment(const Vector3& a, const Vector3& b, Surface& segments)
{
  const Index first = static_cast<Index>(segments.Points.size());
  segments.Points.push_back(a);
  segments.Points.push_back(b);
  segments.Triangles.push_back({ first, first + 1, first + 1 });
}

void AddSingleEdges(const std::vector<std::array<double, 6>>& sorted, Surface& segments)
{
  ForEachGroup(sorted,
    [&](const std::array<double, 6>& e, std::size_t count)
    {
      if (count == 1)
      {
        AddSegment({ e[0], e[1], e[2] }, { e[3], e[4], e[5] }, segments);
      }
    });
}
}

void OpenBoundaries::Add(const Surface& slab, const CleanSurface& clean,
  const std::vector<char>& isInLower, const std::vector<char>& isInUpper)
{
  std::vector<Ends> inLower = std::move(this->InPlane);
  this->InPlane.clear();
  ForEachGroup(SortedEdges(clean.Surface),
    [&](const Edge& edge, std::size_t count)
    {
      const Index a = clean.InputPoint[edge[0]];
      const Index b = clean.InputPoint[edge[1]];
      const Vector3& p = slab.Points[a];
      const Vector3& q = slab.Points[b];
      const bool isUpper = isInUpper[a] != 0 && isInUpper[b] != 0;
      if (isUpper || (isInLower[a] != 0 && isInLower[b] != 0))
      {
        Ends ends = { p[0], p[1], p[2], q[0], q[1], q[2] };
        if (std::lexicographical_compare(q.begin(), q.end(), p.begin(), p.end()))
        {
          std::rotate(ends.begin(), ends.begin() + 3, ends.end());
        }
        std::vector<Ends>& plane = isUpper ? this->InPlane : inLower;
        plane.insert(plane.end(), count, ends);
      }
      else if (count == 1)
      {
        AddSegment(p, q, this->Segments);
      }
    });
  std::sort(inLower.begin(), inLower.end());
  AddSingleEdges(inLower, this->Segments);
}

//------------------------------------------------------------------------------
void OpenBoundaries::Prove(const Surface& result, double tolerance, int threads, ErrorProof& proof)
{
  std::sort(this->InPlane.begin(), this->InPlane.end());
  AddSingleEdges(this->InPlane, this->Segments);
  Surface ofResult;
  ForEachGroup(SortedEdges(result),
    [&](const Edge& edge, std::size_t count)
    {
      if (count == 1)
      {
        AddSegment(result.Points[edge[0]], result.Points[edge[1]], ofResult);
      }
    });
  const bool isBefore = !this->Segments.Triangles.empty();
  const bool isAfter = !ofResult.Triangles.empty();
  proof.BoundariesCompared = true;
  proof.Boundaries = isBefore
    ? (isAfter ? BoundaryPresence::Both : BoundaryPresence::ReferenceOnly)
    : (isAfter ? BoundaryPresence::ResultOnly : BoundaryPresence::Neither);
  if (!isBefore && !isAfter)
  {
    return;
  }
  CertificateOptions question;
  question.Tolerance = tolerance;
  question.TightBounds = false;
  question.WithBoundaries = false; // segments are surfaces here
  question.NumberOfThreads = threads;
  const Certificate found = Certify(this->Segments, ofResult, question);
  const bool isGood = found.Status == CertificateStatus::Good;
  const ProofStatus status = isGood ? found.Proof : ProofStatus::Violated;
  proof.Status =
    proof.Status == ProofStatus::Violated ? proof.Status : std::max(proof.Status, status);
  const auto boundsOf = [](const DirectedCertificate& directed) {
    return ProvedDistance{ directed.Distance.Lower, directed.Distance.Upper };
  };
  proof.BoundaryInputToOutput = boundsOf(found.ReferenceToResult);
  proof.BoundaryOutputToInput = boundsOf(found.ResultToReference);
}
}
