// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TunnelOperation.h"

#include "Geometry/BoundingTree.h"
#include "Mesh/Checksum.h"
#include "Mesh/ManifoldPatches.h"
#include "Repair/Diagnostics/Diagnostics.h"
#include "Repair/Tunnels/CloseTunnels.h"
#include "Run/Input/Tolerances.h"

#include <utility>

namespace bonedecimate
{
namespace
{
/// Points that have a tolerance of 0, or duplicates because the surface is not manifold there.
std::vector<char> FixedPoints(const CleanSurface& clean, const std::vector<double>* tolerances)
{
  std::vector<char> isFixed(clean.Surface.Points.size(), 0);
  const std::vector<Index>& originals = clean.ManifoldPatches.OriginalVertices;
  for (std::size_t v = 0; v < originals.size(); ++v)
  {
    if (originals[v] != static_cast<Index>(v))
    {
      isFixed[v] = isFixed[static_cast<std::size_t>(originals[v])] = 1;
    }
  }
  const std::vector<double> ofPoints =
    tolerances != nullptr ? TolerancesOf(clean, *tolerances) : std::vector<double>();
  for (std::size_t v = 0; v < ofPoints.size(); ++v)
  {
    isFixed[v] = isFixed[v] != 0 || ofPoints[v] == 0.0 ? 1 : 0;
  }
  return isFixed;
}

class TunnelOperation : public InputOperation
{
public:
  std::string Apply(RunRequest& request, const Monitor& monitor) override
  {
    this->Before = request;
    request.Options.TunnelSize = 0.0;
    this->IsRead = this->Close(monitor);
    if (!this->Ids.empty())
    {
      request.Input = &this->Closed;
      request.Options.DiagnoseInput = false;
      this->ChangeInputs(request.Inputs);
    }
    return {};
  }

  void Restore(Result& result) override
  {
    result.Report.Tunnels = this->IsRead ? std::move(this->Figures) : TunnelFigures();
    if (!this->Ids.empty())
    {
      this->NameInput(result);
    }
  }

private:
  /// False if the input will be rejected.
  bool Close(const Monitor& monitor)
  {
    const int threads = this->Before.Options.NumberOfThreads;
    CleanSurface clean = Clean(*this->Before.Input, this->Before.Options.MergePoints, threads);
    const std::vector<double>* tolerances = this->Before.Inputs.Tolerances;
    if (clean.Status != InputStatus::Good ||
      (tolerances != nullptr && tolerances->size() != this->Before.Input->Points.size()))
    {
      return false;
    }
    this->Cleaning = clean.Statistics;
    SplitIntoManifoldPatches(clean, threads);
    TunnelConstraints constraints = { FixedPoints(clean, tolerances), {} };
    for (const Index triangle : clean.InputTriangle)
    {
      if (this->Before.Inputs.Labels != nullptr)
      {
        constraints.Labels.push_back(
          this->Before.Inputs.Labels->OfTriangle[static_cast<std::size_t>(triangle)]);
      }
    }
    SurfaceWithoutTunnels made =
      CloseTunnels(clean.Surface, constraints, this->Before.Options.TunnelSize, threads, monitor);
    this->Figures = std::move(made.Figures);
    for (ClosedTunnel& tunnel : this->Figures.Closed)
    {
      tunnel.Center += clean.Origin;
    }
    if (!made.Added.empty())
    {
      this->Assemble(clean, made);
    }
    return true;
  }

  /// The input without what was removed, and then the plugs.
  void Assemble(const CleanSurface& clean, const SurfaceWithoutTunnels& made)
  {
    std::vector<char> isRemoved(this->Before.Input->Triangles.size(), 0);
    for (std::size_t t = 0; t < made.IsRemoved.size(); ++t)
    {
      isRemoved[static_cast<std::size_t>(clean.InputTriangle[t])] = made.IsRemoved[t];
    }
    this->Closed.Points = this->Before.Input->Points;
    for (std::size_t t = 0; t < isRemoved.size(); ++t)
    {
      if (isRemoved[t] == 0)
      {
        this->Closed.Triangles.push_back(this->Before.Input->Triangles[t]);
        this->Ids.push_back(static_cast<Index>(t));
      }
    }
    this->FirstPlug = this->Ids.size();
    const auto pointOf = [&clean](Index point)
    { return clean.InputPoint[static_cast<std::size_t>(point)]; };
    for (std::size_t i = 0; i < made.Added.size(); ++i)
    {
      const Triangle& corners = made.Added[i];
      this->Closed.Triangles.push_back(
        { pointOf(corners[0]), pointOf(corners[1]), pointOf(corners[2]) });
      this->Ids.push_back(clean.InputTriangle[static_cast<std::size_t>(made.Replaced[i])]);
    }
  }

  void ChangeInputs(RunInputs& inputs)
  {
    inputs.Regions = nullptr; // which are those of the input
    if (this->Before.Inputs.Labels != nullptr)
    {
      this->ClosedLabels.Names = this->Before.Inputs.Labels->Names;
      for (const Index id : this->Ids)
      {
        this->ClosedLabels.OfTriangle.push_back(
          this->Before.Inputs.Labels->OfTriangle[static_cast<std::size_t>(id)]);
      }
      inputs.Labels = &this->ClosedLabels;
    }
  }

  /// Makes what names triangles and counts what was read refer to the input.
  void NameInput(Result& result) const
  {
    Report& report = result.Report;
    CleaningStatistics cleaning = this->Cleaning;
    std::swap(cleaning, report.Cleaning);
    report.Cleaning.NonManifoldPoints = cleaning.NonManifoldPoints;
    report.Cleaning.FirstNonManifoldPoint = cleaning.FirstNonManifoldPoint;
    report.Cleaning.BadTolerances = cleaning.BadTolerances;
    report.Cleaning.FirstBadTolerance = cleaning.FirstBadTolerance;
    report.Cleaning.BadEdgeLengths = cleaning.BadEdgeLengths;
    report.Cleaning.FirstBadEdgeLength = cleaning.FirstBadEdgeLength;
    report.Cleaning.CoarsePoints = cleaning.CoarsePoints;
    report.Cleaning.MeetingPoints = cleaning.MeetingPoints;
    report.Cleaning.FirstCoarsePoint = cleaning.FirstCoarsePoint;
    report.Cleaning.MaxRounding = cleaning.MaxRounding;
    report.Cleaning.ConstrainedPoints = cleaning.ConstrainedPoints;
    report.InputChecksum = Checksum(*this->Before.Input, this->Before.Options.NumberOfThreads);
    if (this->Before.Options.DiagnoseInput)
    {
      report.Diagnostics = Diagnose(*this->Before.Input, this->Before.Options.NumberOfThreads);
    }
    if (!result.Origins.NearestTriangle.empty() || !result.Origins.TriangleAtCentroid.empty())
    {
      this->NameOrigins(result);
    }
  }

  void NameOrigins(Result& result) const
  {
    const BoundingTree tree(*this->Before.Input, this->Before.Options.NumberOfThreads);
    SurfaceOrigins& origins = result.Origins;
    const auto isPlug = [this](Index triangle)
    { return static_cast<std::size_t>(triangle) >= this->FirstPlug; };
    for (std::size_t p = 0; p < origins.NearestTriangle.size(); ++p)
    {
      Index& triangle = origins.NearestTriangle[p];
      if (isPlug(triangle))
      {
        const BoundingTree::Nearest nearest = tree.FindNearest(result.Surface.Points[p]);
        triangle = nearest.Triangle;
        origins.Barycentric[p] = nearest.Point.Weights;
      }
      else
      {
        triangle = this->Ids[static_cast<std::size_t>(triangle)];
      }
    }
    for (std::size_t t = 0; t < origins.TriangleAtCentroid.size(); ++t)
    {
      Index& triangle = origins.TriangleAtCentroid[t];
      const Index replaced = this->Ids[static_cast<std::size_t>(triangle)];
      triangle = isPlug(triangle) && this->Before.Inputs.Labels == nullptr
        ? tree.FindNearest(CentroidOf(result.Surface, t)).Triangle
        : replaced; // which has the label of the plug
    }
  }

  static Vector3 CentroidOf(const Surface& surface, std::size_t triangle)
  {
    const Triangle& corners = surface.Triangles[triangle];
    return (surface.Points[static_cast<std::size_t>(corners[0])] +
             surface.Points[static_cast<std::size_t>(corners[1])] +
             surface.Points[static_cast<std::size_t>(corners[2])]) /
      3.0;
  }

  RunRequest Before = {};
  bool IsRead = false;
  CleaningStatistics Cleaning; // of the input
  TunnelFigures Figures;
  Surface Closed;
  // of its triangles in the input; of a plug one that it replaces. Empty: none was closed
  std::vector<Index> Ids;
  std::size_t FirstPlug = 0; // of its triangles
  Labels ClosedLabels;
};
}

std::unique_ptr<InputOperation> MakeTunnelOperation()
{
  return std::make_unique<TunnelOperation>();
}
}
