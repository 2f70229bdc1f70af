// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloseTunnels.h"

#include "EdgeGraph.h"
#include "PlugDistance.h"
#include "ShortLoops.h"
#include "TunnelPlug.h"
#include "WordBasis.h"

#include <algorithm>
#include <set>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/// What lies inside of a loop that does not divide the surface.
enum class Surrounded
{
  Tunnel,
  Bone,
  Unclear
};

/// The remaining triangles at the beginning of a round.
struct Remaining
{
  explicit Remaining(const PluggedSurface& plugged)
  {
    this->Surface.Points = plugged.Whole.Points;
    for (std::size_t t = 0; t < plugged.IsRemoved.size(); ++t)
    {
      if (plugged.IsRemoved[t] == 0)
      {
        this->Surface.Triangles.push_back(plugged.Whole.Triangles[t]);
        this->Ids.push_back(static_cast<Index>(t));
      }
    }
  }

  bonedecimate::Surface Surface;
  std::vector<Index> Ids; // of the triangles in the plugged surface
};

/// The classes of loops in the order of their lengths, so that each tunnel counts once.
class SeenClasses
{
public:
  /// Whether the class of the loop is new: neither seen nor a sum of the last ones.
  bool Add(std::uint64_t signature)
  {
    if (!this->SeenSignatures.insert(signature).second)
    {
      return false;
    }
    if (this->Size == MaxClasses)
    {
      this->Size = 0;
      this->LastClasses = {};
    }
    const bool isNew = this->LastClasses.Add(signature);
    this->Size += isNew ? 1 : 0;
    return isNew;
  }

private:
  static constexpr int MaxClasses = 48; // of 64 words: few are dependent by chance
  std::set<std::uint64_t> SeenSignatures;
  WordBasis LastClasses;
  int Size = 0;
};

class TunnelClosing
{
public:
  TunnelClosing(const Surface& surface, const TunnelConstraints& constraints, double diameter,
    int threads, const Monitor& monitor)
    : Plugged(surface, threads)
    , Constraints(constraints)
    , Girth(Pi * diameter)
    , Threads(threads)
    , Progress(monitor)
  {
    this->Figures.IsRequested = true;
  }

  SurfaceWithoutTunnels Close()
  {
    bool shouldContinue = true;
    for (bool isFirst = true; shouldContinue; isFirst = false)
    {
      shouldContinue = this->CloseSome(isFirst);
    }
    return this->TakeResult();
  }

private:
  /// One round.
  /// @return Whether it closed a tunnel.
  bool CloseSome(bool isFirst)
  {
    const Remaining remaining(this->Plugged);
    const EdgeGraph graph(remaining.Surface, this->Threads);
    if (isFirst)
    {
      this->Figures.GenusBefore = graph.Genus();
      this->Components = graph.Components();
    }
    const auto closed = static_cast<std::int64_t>(this->Figures.Closed.size());
    if (graph.Components() != this->Components ||
      graph.Genus() != this->Figures.GenusBefore - closed)
    {
      this->Undo(); // possible only if signatures are equal by chance
      return false;
    }
    this->Figures.GenusAfter = graph.Genus();
    this->RoundStart = { this->Plugged.IsRemoved, this->Figures.Closed.size() };
    if (graph.Genus() == 0)
    {
      return false;
    }
    const std::vector<ShortLoop> loops = FindShortLoops(graph, remaining.Surface.Points.size(),
      this->Girth, this->Threads, [this](double) { return this->ShouldContinue(); });
    if (!this->ShouldContinue())
    {
      this->RoundStart = {};
      this->Undo();
      return false;
    }
    return this->CloseLoops(loops, graph, remaining);
  }

  bool CloseLoops(
    const std::vector<ShortLoop>& loops, const EdgeGraph& graph, const Remaining& remaining)
  {
    const std::vector<Vector3> normals =
      AreaNormals(remaining.Surface.Points, remaining.Surface.Triangles);
    const PlugMaker maker(
      this->Plugged, graph, remaining.Surface, remaining.Ids, this->Constraints);
    std::vector<char> isChanged(remaining.Surface.Points.size(), 0); // in this round
    WordBasis closed;
    SeenClasses seen;
    std::array<std::int64_t, NumberOfTunnelObstacles> left{};
    const std::size_t before = this->Figures.Closed.size();
    for (const ShortLoop& loop : loops)
    {
      const Surrounded what = this->Surrounds(loop, normals);
      TunnelPlug plug;
      TunnelObstacle obstacle = TunnelObstacle::AmbiguousLoop;
      if (what == Surrounded::Tunnel && closed.IsIndependent(loop.Signature))
      {
        obstacle = maker.Make(loop.Points, plug);
        if (obstacle == TunnelObstacle::NoObstacle && !this->IsChanged(plug, remaining, isChanged))
        {
          this->Replace(plug, loop, remaining, isChanged);
          closed.Add(loop.Signature);
        }
      }
      const bool isNew = seen.Add(loop.Signature);
      left[static_cast<std::size_t>(obstacle)] += isNew && what != Surrounded::Bone ? 1 : 0;
    }
    left[static_cast<std::size_t>(TunnelObstacle::NoObstacle)] = 0;
    this->Figures.Left = left; // those of the last round count
    return this->Figures.Closed.size() > before;
  }

  /// Decides by the normals along the loop: the mean of their components towards the middle,
  /// weighted by length and distance.
  Surrounded Surrounds(const ShortLoop& loop, const std::vector<Vector3>& normals) const
  {
    constexpr double clear = 0.25;
    const std::size_t count = loop.Points.size();
    std::vector<double> lengths(count); // mm, of the loop at each point
    Vector3 center = Vector3::Zero();
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector3& at = this->Plugged.Point(loop.Points[i]);
      lengths[i] = 0.5 *
        ((at - this->Plugged.Point(loop.Points[(i + 1) % count])).norm() +
          (at - this->Plugged.Point(loop.Points[(i + count - 1) % count])).norm());
      center += lengths[i] / loop.Length * at;
    }
    double inwards = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector3 way = center - this->Plugged.Point(loop.Points[i]);
      inwards +=
        lengths[i] * Dot(way, normals[static_cast<std::size_t>(loop.Points[i])].normalized());
      all += lengths[i] * way.norm();
    }
    return inwards > clear * all ? Surrounded::Tunnel
      : inwards < -clear * all   ? Surrounded::Bone
                                 : Surrounded::Unclear;
  }

  bool IsChanged(
    const TunnelPlug& plug, const Remaining& remaining, const std::vector<char>& isChanged) const
  {
    return std::any_of(plug.Band.begin(), plug.Band.end(),
      [&](Index face)
      {
        const Triangle& corners = remaining.Surface.Triangles[static_cast<std::size_t>(face)];
        return std::any_of(corners.begin(), corners.end(),
          [&](Index c) { return isChanged[static_cast<std::size_t>(c)] != 0; });
      });
  }

  void Replace(const TunnelPlug& plug, const ShortLoop& loop, const Remaining& remaining,
    std::vector<char>& isChanged)
  {
    for (const Index face : plug.Band)
    {
      for (const Index corner : remaining.Surface.Triangles[static_cast<std::size_t>(face)])
      {
        isChanged[static_cast<std::size_t>(corner)] = 1;
      }
      this->Plugged
        .IsRemoved[static_cast<std::size_t>(remaining.Ids[static_cast<std::size_t>(face)])] = 1;
    }
    Index replaced = remaining.Ids[static_cast<std::size_t>(plug.Band.front())];
    const auto first = static_cast<Index>(this->Plugged.InitialTriangles);
    replaced = replaced < first
      ? replaced
      : this->Plugged.Replaced[static_cast<std::size_t>(replaced - first)];
    for (const Triangle& corners : plug.Caps)
    {
      this->Plugged.Whole.Triangles.push_back(corners);
      this->Plugged.IsRemoved.push_back(0);
      this->Plugged.Replaced.push_back(replaced);
    }
    ClosedTunnel tunnel = { loop.Length / Pi, plug.Volume };
    for (const Index point : loop.Points)
    {
      tunnel.Center += this->Plugged.Point(point) / static_cast<double>(loop.Points.size());
    }
    this->Figures.Closed.push_back(tunnel);
  }

  /// Restores the state at the beginning of the last round, or the initial one if nothing is kept.
  void Undo()
  {
    this->RoundStart.IsRemoved.resize(
      std::max(this->RoundStart.IsRemoved.size(), this->Plugged.InitialTriangles), 0);
    this->Plugged.IsRemoved = this->RoundStart.IsRemoved;
    this->Plugged.IsRemoved.resize(this->Plugged.Whole.Triangles.size(), 1);
    this->Figures.Closed.resize(this->RoundStart.ClosedTunnels);
    this->Figures.GenusAfter =
      this->Figures.GenusBefore - static_cast<std::int64_t>(this->RoundStart.ClosedTunnels);
  }

  bool ShouldContinue()
  {
    this->IsAborted = this->IsAborted || (this->Progress && !this->Progress(0.0));
    return !this->IsAborted;
  }

  SurfaceWithoutTunnels TakeResult()
  {
    SurfaceWithoutTunnels made;
    const auto first = static_cast<std::ptrdiff_t>(this->Plugged.InitialTriangles);
    for (std::size_t t = this->Plugged.InitialTriangles; t < this->Plugged.IsRemoved.size(); ++t)
    {
      if (this->Plugged.IsRemoved[t] == 0)
      {
        made.Added.push_back(this->Plugged.Whole.Triangles[t]);
        made.Replaced.push_back(this->Plugged.Replaced[t - this->Plugged.InitialTriangles]);
      }
    }
    made.IsRemoved.assign(this->Plugged.IsRemoved.begin(), this->Plugged.IsRemoved.begin() + first);
    this->Figures.Distance = this->MeasureDistance(made);
    made.Figures = std::move(this->Figures);
    return made;
  }

  /// mm, from the plugs to the input, and from what they replace to the plugs.
  double MeasureDistance(const SurfaceWithoutTunnels& made) const
  {
    if (made.Added.empty())
    {
      return 0.0;
    }
    const Surface plugs = { this->Plugged.Whole.Points, made.Added };
    Surface replaced = { this->Plugged.Whole.Points, {} };
    for (std::size_t t = 0; t < made.IsRemoved.size(); ++t)
    {
      if (made.IsRemoved[t] != 0)
      {
        replaced.Triangles.push_back(this->Plugged.Whole.Triangles[t]);
      }
    }
    return std::max(MaxDistanceTo(this->Plugged.Tree, plugs),
      MaxDistanceTo(BoundingTree(plugs, this->Threads), replaced));
  }

  struct RoundState
  {
    std::vector<char> IsRemoved;
    std::size_t ClosedTunnels = 0;
  };

  PluggedSurface Plugged;
  const TunnelConstraints& Constraints;
  double Girth; // mm
  int Threads;
  const Monitor& Progress;
  bool IsAborted = false;
  std::int64_t Components = 0;
  RoundState RoundStart; // at the beginning of the round
  TunnelFigures Figures;
};
}

SurfaceWithoutTunnels CloseTunnels(const Surface& surface, const TunnelConstraints& constraints,
  double diameter, int threads, const Monitor& monitor)
{
  return TunnelClosing(surface, constraints, diameter, threads, monitor).Close();
}
}
