// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabRun.h"

#include "GrowingSurface.h"
#include "Mesh/Checksum.h"
#include "Mesh/Cleaning.h"
#include "Mesh/Statistics.h"
#include "OpenBoundaries.h"
#include "Proof/Certificate/Certificate.h"
#include "Run/Input/EdgeLengths.h"
#include "Run/Output/CompareShapes.h"
#include "Run/Output/ListLeftOut.h"
#include "Run/Report/MergeReports.h"
#include "SlabOptions.h"
#include "SlabTotals.h"
#include "ZoneRun.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Points so near to a plane, as a fraction of their largest coordinate, are in it:
/// single precision is that coarse.
constexpr double PlaneSlack = 1e-6;
/// How far below its plane the next run goes on, in mean edges of the result (over its area) and in
/// largest errors.
constexpr double EdgesOfZone = 3.0;
constexpr double ErrorsOfZone = 2.0;
/// Below the zone, where boundary edges are told from edges of a cut: less than ZoneMargin().
constexpr double ErrorsOfBoundaries = 2.0;
/// Largest number of original triangles in the zone, relative to that of the largest slab.
constexpr double MaxOfZone = 1.5;
}

class SlabRun::Implementation
{
public:
  Implementation(const Options& options, const SlabAxis& axis, const SlabInputs& inputs)
    : Effective(OptionsOfSlabs(options, inputs, this->Message))
    , Axis(axis)
    , Inputs(inputs)
    , Bottom(axis.Bottom)
  {
    this->Status = this->Message.empty() ? SlabStatus::Good : SlabStatus::BadOptions;
  }

  SlabStatus Add(Slab slab, const Monitor& monitor)
  {
    if (this->Status == SlabStatus::Good && this->IsValid(slab))
    {
      this->Figures.Slabs += slab.Surface.Triangles.empty() ? 0 : 1;
      this->Figures.MaxSlab =
        std::max(this->Figures.MaxSlab, static_cast<std::int64_t>(slab.Surface.Triangles.size()));
      this->Count(slab);
      this->DecimateTo(
        slab.Top, { std::move(slab.Surface), std::move(slab.BoundaryLabels) }, monitor);
    }
    return this->Status;
  }

  /// What is left: points in the last plane.
  Result Finish()
  {
    Result whole;
    if (this->Status == SlabStatus::Good)
    {
      this->DecimateTo(Infinity, {}, {});
    }
    whole.Report.Edits = this->OfZones.Edits;
    whole.Report.Seconds = this->OfZones.Seconds;
    whole.Report.RunningError = std::numeric_limits<double>::quiet_NaN(); // is not measured
    whole.Report.Requested = this->Effective;
    if (this->Status == SlabStatus::Good)
    {
      SurfacePiece all = this->Growing.Release();
      whole.Surface = std::move(all.Shape);
      whole.BoundaryLabels = std::move(all.Labels);
      this->Totals.Write(whole.Report);
      whole.Report.Output = Describe(whole.Surface, this->Effective.NumberOfThreads);
      CompareShapes(whole.Surface, this->Effective, ShapeLimitsOf(this->Effective), Vector3::Zero(),
        whole.Report);
      whole.Report.Stop = StopReason::ErrorReached;
      if (this->Proof.WasMade)
      {
        this->Boundaries.Prove(whole.Surface, this->Effective.MaximumError,
          this->Effective.NumberOfThreads, this->Proof);
      }
      whole.Report.Proof = this->Proof;
      std::vector<LeftOutShape> leftOut = this->Totals.LeftOut();
      leftOut.insert(leftOut.end(), this->Inputs.LeftOut.begin(), this->Inputs.LeftOut.end());
      MeasureLeftOut(std::move(leftOut), whole);
      whole.Report.OutputChecksum =
        TriangleChecksum(whole.Surface, this->Effective.NumberOfThreads);
    }
    return whole;
  }

  std::string Message;
  const Options Effective; // without a preset
  const SlabAxis Axis;
  const SlabInputs Inputs;
  SlabFigures Figures;
  SlabTotals Totals;
  Report OfZones; ///< Sums.
  SlabStatus Status = SlabStatus::Good;

private:
  void Count(const Slab& slab)
  {
    const CleanSurface clean = Clean(slab.Surface, true, this->Effective.NumberOfThreads);
    const std::vector<char> isInLower = this->AreInPlane(slab.Surface, this->Bottom);
    const std::vector<char> isInUpper = this->AreInPlane(slab.Surface, slab.Top);
    this->Totals.Add(slab, clean, isInLower, isInUpper, this->Effective.NumberOfThreads);
    this->Boundaries.Add(slab.Surface, clean, isInLower, isInUpper);
  }

  double Along(const Vector3& p) const { return Dot(this->Axis.Direction, p); }
  Zone Between(double low, double high) const { return { this->Axis.Direction, low, high }; }
  const LabelMapSource* Source() const
  {
    const LabelMapSource& map = this->Inputs.LabelMap;
    return map.Grid.Dimensions[0] > 0 || !map.Values.empty() ? &map : nullptr;
  }

  bool Fail(SlabStatus status, const std::string& message)
  {
    this->Status = status;
    this->Message = message;
    return false;
  }

  bool IsValid(const Slab& slab)
  {
    if (!(slab.Top > this->Bottom))
    {
      return this->Fail(
        SlabStatus::BadSlab, "The upper plane of a slab is not above the lower one.");
    }
    this->Slack = std::max(this->Slack, PlaneSlack * MaxCoordinateOf(slab.Surface));
    for (const Triangle& c : slab.Surface.Triangles)
    {
      for (const Index corner : c)
      {
        const bool isThere =
          corner >= 0 && static_cast<std::size_t>(corner) < slab.Surface.Points.size();
        const double along = isThere ? this->Along(slab.Surface.Points[corner]) : Infinity;
        if (!(along >= this->Bottom - this->Slack && along <= slab.Top + this->Slack))
        {
          return this->Fail(
            SlabStatus::BadSlab, "A triangle is not between the planes of its slab.");
        }
      }
    }
    return slab.BoundaryLabels.empty() ||
      slab.BoundaryLabels.size() == slab.Surface.Triangles.size() ||
      this->Fail(SlabStatus::BadSlab, "A slab does not have one pair of labels for each triangle.");
  }

  /// Whether each point is in the plane.
  std::vector<char> AreInPlane(const Surface& surface, double plane) const
  {
    std::vector<char> are;
    are.reserve(surface.Points.size());
    for (const Vector3& p : surface.Points)
    {
      are.push_back(std::abs(this->Along(p) - plane) <= this->Slack ? 1 : 0);
    }
    return are;
  }

  /// Runs the slab together with the zone below it.
  void DecimateTo(double top, const SurfacePiece& slab, const Monitor& monitor)
  {
    const double error = this->Effective.MaximumError;
    ZoneInput zone;
    zone.EditZone = this->Between(this->ZoneFrom, top - this->Slack);
    zone.BoundaryZone =
      this->Between(this->ZoneFrom - ErrorsOfBoundaries * error, top - this->Slack);
    GrowingSurface::Strip strip =
      this->Growing.Take(this->Between(this->ZoneFrom - ZoneReach(error), Infinity));
    zone.Strip = Joined(std::move(strip.Piece), slab);
    zone.Original = Joined(std::move(this->Below), slab);
    // Nothing of the original within reach of the zone: nothing of the result is in it.
    const bool isEmpty =
      zone.Strip.Shape.Triangles.empty() || zone.Original.Shape.Triangles.empty();
    if (isEmpty)
    {
      this->Growing.PutBack(strip, zone.Strip);
    }
    else
    {
      zone.IsFinished = this->FarFromSlab(zone.Strip.Shape);
      ZoneResult made =
        DecimateZone(zone, this->Effective, this->Source(), this->Inputs.InputIsSingle, monitor);
      this->Take(made, zone.Strip);
      this->Growing.PutBack(strip, zone.Strip);
      this->ZoneFrom = std::max({ this->ZoneFrom, this->MinZone(zone.Original.Shape),
        top - EdgesOfZone * MeanEdge(zone.Strip.Shape) - ErrorsOfZone * error });
    }
    this->Bottom = top;
    this->Below =
      CutBetween(zone.Original, this->Between(this->ZoneFrom - ZoneMargin(error), Infinity));
    this->Growing.Finish(this->Between(this->ZoneFrom - ZoneReach(error), Infinity));
  }

  /// mm, of a zone with so many original triangles as the memory of a slab allows.
  double MinZone(const Surface& original) const
  {
    const std::size_t most =
      static_cast<std::size_t>(MaxOfZone * static_cast<double>(this->Figures.MaxSlab));
    if (original.Triangles.size() <= most)
    {
      return -Infinity;
    }
    std::vector<double> positions; // of triangles
    positions.reserve(original.Triangles.size());
    for (const Triangle& c : original.Triangles)
    {
      positions.push_back(this->Along(original.Points[c[0]]));
    }
    const auto lowest = positions.end() - static_cast<std::ptrdiff_t>(most);
    std::nth_element(positions.begin(), lowest, positions.end());
    return *lowest;
  }

  /// Whether the component of a point ends below the slab, so that earlier runs have finished it.
  std::vector<char> FarFromSlab(const Surface& surface) const
  {
    const Components found = FindComponents(surface);
    std::vector<char> isNear(static_cast<std::size_t>(found.Count), 0);
    for (std::size_t i = 0; i < surface.Points.size(); ++i)
    {
      isNear[found.OfPoint[i]] |=
        this->Along(surface.Points[i]) >= this->Bottom - this->Slack ? 1 : 0;
    }
    std::vector<char> isFar;
    isFar.reserve(found.OfPoint.size());
    for (const Index component : found.OfPoint)
    {
      isFar.push_back(isNear[component] != 0 ? 0 : 1);
    }
    return isFar;
  }

  /// @param strip Becomes the result, unless it is not proved.
  void Take(ZoneResult& made, SurfacePiece& strip)
  {
    const Report& report = made.Run.Report;
    if (report.Status != InputStatus::Good)
    {
      this->Fail(SlabStatus::BadSlab, InputMessage(report));
    }
    else if (report.Stop == StopReason::Aborted)
    {
      this->Fail(SlabStatus::Aborted, "The run was aborted.");
    }
    else if (made.Proof == ProofStatus::Violated || made.Proof == ProofStatus::Undecided)
    {
      this->Figures.UnprovedSlabs += 1;
    }
    else
    {
      AddPart(report, this->OfZones);
      this->AddProof(made);
      strip = { std::move(made.Run.Surface), std::move(made.Run.BoundaryLabels) };
    }
  }

  /// Only upper bounds hold for the whole.
  void AddProof(const ZoneResult& made)
  {
    ErrorProof& proof = this->Proof;
    proof.WasMade = this->Effective.ProveResult;
    proof.Status = made.Proof;
    proof.Tolerance = this->Effective.MaximumError;
    proof.InputToOutput.Upper = std::max(proof.InputToOutput.Upper, made.OriginalToResult.Upper);
    proof.OutputToInput.Upper = std::max(proof.OutputToInput.Upper, made.ResultToOriginal.Upper);
  }

  double Slack = 0.0;          // mm
  double Bottom;               // mm, of the next slab
  double ZoneFrom = -Infinity; // mm, where edits of the next run begin
  SurfacePiece Below;          // the original there
  GrowingSurface Growing;
  OpenBoundaries Boundaries;
  ErrorProof Proof;
};

SlabRun::SlabRun(const Options& options, const SlabAxis& axis, const SlabInputs& inputs)
  : Run(std::make_unique<Implementation>(options, axis, inputs))
{
}

SlabRun::~SlabRun() = default;

//------------------------------------------------------------------------------
SlabStatus SlabRun::Status() const
{
  return this->Run->Status;
}

//------------------------------------------------------------------------------
std::string SlabRun::Message() const
{
  return this->Run->Message;
}

//------------------------------------------------------------------------------
SlabStatus SlabRun::Add(Slab slab, const Monitor& monitor)
{
  return this->Run->Add(std::move(slab), monitor);
}

//------------------------------------------------------------------------------
Result SlabRun::Finish()
{
  Result whole = this->Run->Finish();
  this->Run->Figures.ComponentsBefore = this->Run->Totals.NumberOfComponents();
  this->Run->Figures.VolumeBefore = this->Run->Totals.Volume();
  return whole;
}

//------------------------------------------------------------------------------
const SlabFigures& SlabRun::Figures() const
{
  return this->Run->Figures;
}
}
