// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegionMatch.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
namespace
{
/// Corners from the least on, and the triangle.
struct Candidate
{
  Triangle Corners;
  Index Id;

  bool operator<(const Candidate& other) const
  {
    return this->Corners != other.Corners ? this->Corners < other.Corners : this->Id < other.Id;
  }
};

Triangle FromLeast(Triangle c)
{
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

/// Triangles of the part that are not of the region.
std::vector<Candidate> UnchangedTriangles(const RegionPart& part)
{
  const std::vector<Index>& region = part.Covered.Triangles;
  std::vector<Candidate> unchanged;
  std::size_t next = 0;
  for (std::size_t t = 0; t < part.Triangles.size(); ++t)
  {
    if (next < region.size() && region[next] == part.Triangles[t])
    {
      ++next;
      continue;
    }
    unchanged.push_back({ FromLeast(part.Surface.Triangles[t]), static_cast<Index>(t) });
  }
  return unchanged;
}

/// False if a corner of an unchanged triangle is not in the result.
bool MatchPoints(const std::vector<Candidate>& unchanged, RegionPart& part)
{
  part.OldPoint.assign(part.Result.Surface.Points.size(), None);
  const std::vector<Index>& outputPoint = part.Result.Origins.OutputPoint;
  for (const Candidate& candidate : unchanged)
  {
    for (const Index point : candidate.Corners)
    {
      const Index output = outputPoint[point];
      if (output == None || part.Result.Surface.Points[output] != part.Surface.Points[point] ||
        (part.OldPoint[output] != None && part.OldPoint[output] != point))
      {
        return false;
      }
      part.OldPoint[output] = point;
    }
  }
  return true;
}
}

bool MatchUnchanged(RegionPart& part)
{
  std::vector<Candidate> unchanged = UnchangedTriangles(part);
  if (part.Result.Origins.OutputPoint.size() != part.Surface.Points.size() ||
    !MatchPoints(unchanged, part))
  {
    return false;
  }
  std::sort(unchanged.begin(), unchanged.end());
  std::vector<char> isFound(unchanged.size(), 0);
  std::size_t found = 0;
  part.OldTriangle.assign(part.Result.Surface.Triangles.size(), None);
  for (std::size_t t = 0; t < part.OldTriangle.size(); ++t)
  {
    const Triangle& c = part.Result.Surface.Triangles[t];
    const Triangle old = { part.OldPoint[c[0]], part.OldPoint[c[1]], part.OldPoint[c[2]] };
    const Triangle corners = FromLeast(old);
    auto at = static_cast<std::size_t>(
      std::lower_bound(unchanged.begin(), unchanged.end(), Candidate{ corners, None }) -
      unchanged.begin());
    while (at < unchanged.size() && unchanged[at].Corners == corners && isFound[at] != 0)
    {
      ++at;
    }
    if (corners[0] != None && at < unchanged.size() && unchanged[at].Corners == corners)
    {
      isFound[at] = 1;
      ++found;
      part.OldTriangle[t] = unchanged[at].Id;
    }
  }
  return found == unchanged.size();
}
}
