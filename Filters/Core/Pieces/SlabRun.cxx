// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlabRun.h"

#include "Certificate/Certificate.h"
#include "GrowingSurface.h"
#include "Input/VoxelSize.h"
#include "Junction.h"
#include "Mesh/Statistics.h"
#include "Options/OptionTable.h"
#include "SlabOptions.h"
#include "SlabTotals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace bonedecimate
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// Points so near to a plane, as a fraction of their largest coordinate, are in it: single precision is that coarse.
constexpr double PlaneSlack = 1e-6;
/// mm / mm: thinner slabs are joined with the next one, so that the surroundings of a junction end within its two slabs.
constexpr double ErrorsOfSlab = 16.0;
/// In largest errors: a zone ends so far from the next plane that its junction reads nothing beyond that plane.
constexpr double ErrorsBeyondZone = 7.0;
/// Width of a zone on each side of its plane, in mean edges of the result and in largest errors.
constexpr double EdgesOfZone = 6.0;
constexpr double ErrorsOfZone = 2.0;
/// Of the progress of a slab.
constexpr double SlabDoneAt = 0.7;
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

  SlabStatus Add(Slab slab, bool isLast, const Monitor& monitor)
  {
    if (this->Status != SlabStatus::Good || !this->IsValid(slab))
    {
      return this->Status;
    }
    this->JoinWaiting(slab);
    if (!isLast && slab.Top - this->Bottom < ErrorsOfSlab * this->Effective.MaximumError)
    {
      this->Waiting = std::move(slab);
      return this->Status;
    }
    const double top = slab.Top;
    const Monitor part = monitor ? PartOf(monitor, 0.0, SlabDoneAt) : monitor;
    if (this->DecimateSlab(slab, part))
    {
      const double width = isLast ? Infinity : this->Width;
      this->KeepOriginal(std::move(slab), width);
      this->DecimateJunction(width, monitor ? PartOf(monitor, SlabDoneAt, 1.0) : monitor);
      this->Bottom = top;
      this->BelowWidth = this->Width;
    }
    return this->Status;
  }

  /// What is left: a thin slab, and points in the last plane.
  Result Finish()
  {
    Result whole;
    if (this->Waiting)
    {
      Slab slab = std::move(*this->Waiting);
      this->Waiting.reset();
      this->Add(std::move(slab), true, {});
    }
    if (this->Status == SlabStatus::Good)
    {
      this->Growing.Append({}, {}, {});
      this->KeepOriginal({}, 0.0);
      this->DecimateJunction(Infinity, {});
    }
    whole.Report.Requested = this->Effective;
    if (this->Status == SlabStatus::Good)
    {
      SurfacePiece all = this->Growing.Release();
      whole.Surface = std::move(all.Shape);
      whole.BoundaryLabels = std::move(all.Labels);
      this->Totals.Write(whole.Report);
      whole.Report.Output = Describe(whole.Surface, this->Effective.NumberOfThreads);
      whole.Report.Stop = StopReason::ErrorReached;
      whole.Report.Proof = this->Proof;
    }
    return whole;
  }

  std::string Message;
  const Options Effective; // without a preset
  const SlabAxis Axis;
  const SlabInputs Inputs;
  SlabFigures Figures;
  SlabTotals Totals;
  SlabStatus Status = SlabStatus::Good;

private:
  double Along(const Vector3& p) const { return this->Axis.Direction.dot(p); }
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
    const double bottom = this->Waiting ? this->Waiting->Top : this->Bottom;
    if (!(slab.Top > bottom))
    {
      return this->Fail(
        SlabStatus::BadSlab, "The upper plane of a slab is not above the lower one.");
    }
    this->Slack = std::max(this->Slack, PlaneSlack * LargestCoordinateOf(slab.Surface));
    for (const Triangle& c : slab.Surface.Triangles)
    {
      for (const Index corner : c)
      {
        const bool isThere =
          corner >= 0 && static_cast<std::size_t>(corner) < slab.Surface.Points.size();
        const double along = isThere ? this->Along(slab.Surface.Points[corner]) : Infinity;
        if (!(along >= bottom - this->Slack && along <= slab.Top + this->Slack))
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

  /// Thin slabs become one.
  void JoinWaiting(Slab& slab)
  {
    if (this->Waiting)
    {
      SurfacePiece both =
        Joined({ std::move(this->Waiting->Surface), std::move(this->Waiting->BoundaryLabels) },
          { std::move(slab.Surface), std::move(slab.BoundaryLabels) });
      slab.Surface = std::move(both.Shape);
      slab.BoundaryLabels = std::move(both.Labels);
      this->Waiting.reset();
    }
  }

  /// Of each point, whether it is in the plane.
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

  /// Its points in planes that other slabs have, too, stay.
  bool DecimateSlab(const Slab& slab, const Monitor& monitor)
  {
    SurfacePart part;
    part.IsShared = this->AreInPlane(slab.Surface, slab.Top);
    const std::vector<char> isInLower = this->AreInPlane(slab.Surface, this->Bottom);
    for (std::size_t i = 0; i < isInLower.size() && this->HasSlabBelow; ++i)
    {
      part.IsShared[i] |= isInLower[i];
    }
    part.EditZone = this->Between(
      this->HasSlabBelow ? this->Bottom + this->Slack : -Infinity, slab.Top - this->Slack);
    LabelMapSource source = this->Inputs.LabelMap;
    source.OfTriangle = slab.BoundaryLabels;
    RunInputs inputs;
    inputs.InputIsSingle = this->Inputs.InputIsSingle;
    inputs.LabelMap = this->Source() != nullptr ? &source : nullptr;
    inputs.Part = &part;
    Result result;
    if (!slab.Surface.Triangles.empty())
    {
      result = Decimate(slab.Surface, this->Effective, monitor, inputs);
    }
    const Report& report = result.Report;
    if (report.Status != InputStatus::Good)
    {
      return this->Fail(SlabStatus::BadSlab, InputMessage(report));
    }
    if (report.Stop == StopReason::Aborted)
    {
      return this->Fail(SlabStatus::Aborted, "The run was aborted.");
    }
    this->TakeSlab(slab, result);
    return true;
  }

  void TakeSlab(const Slab& slab, Result& result)
  {
    const std::vector<char> isInLower = this->AreInPlane(result.Surface, this->Bottom);
    const std::vector<char> isInUpper = this->AreInPlane(result.Surface, slab.Top);
    this->Totals.Add(slab, result, isInLower, isInUpper);
    const bool isEmpty = slab.Surface.Triangles.empty();
    this->Figures.Slabs += isEmpty ? 0 : 1;
    this->Figures.LargestSlab =
      std::max(this->Figures.LargestSlab, static_cast<std::int64_t>(slab.Surface.Triangles.size()));
    if (!isEmpty)
    {
      const ErrorProof& proof = result.Report.Proof;
      this->AddProof(proof.WasMade, proof.Status, proof.InputToOutput, proof.OutputToInput);
    }
    const double error = this->Effective.MaximumError;
    this->Width = std::min(slab.Top - this->Bottom - ErrorsBeyondZone * error,
      EdgesOfZone * MeanEdge(result.Report.Output) + ErrorsOfZone * error);
    this->Growing.Append(
      { std::move(result.Surface), std::move(result.BoundaryLabels) }, isInLower, isInUpper);
    this->HasSlabBelow = this->HasSlabBelow || !isEmpty;
  }

  /// Only upper bounds hold for the whole.
  void AddProof(
    bool wasMade, ProofStatus status, const ProvedDistance& there, const ProvedDistance& back)
  {
    const bool isFirst = this->Proof.Tolerance == 0.0;
    this->Proof.Tolerance = this->Effective.MaximumError;
    this->Proof.WasMade = (isFirst || this->Proof.WasMade) && wasMade;
    const bool isWorse = isFirst || status == ProofStatus::Violated ||
      (status == ProofStatus::Undecided && this->Proof.Status == ProofStatus::Proved);
    this->Proof.Status = isWorse ? status : this->Proof.Status;
    this->Proof.InputToOutput.Upper = std::max(this->Proof.InputToOutput.Upper, there.Upper);
    this->Proof.OutputToInput.Upper = std::max(this->Proof.OutputToInput.Upper, back.Upper);
  }

  /// What the junctions at both planes need of the original.
  /// @param width mm, of the zone above the lower plane.
  void KeepOriginal(Slab slab, double width)
  {
    const double margin = JunctionMargin(this->Effective.MaximumError);
    const SurfacePiece original = { std::move(slab.Surface), std::move(slab.BoundaryLabels) };
    this->Below = std::move(this->Next);
    this->Above = CutBetween(original, this->Between(-Infinity, this->Bottom + width + margin));
    this->Next = CutBetween(original, this->Between(slab.Top - this->Width - margin, Infinity));
  }

  /// @param width mm, of the zone above the plane.
  void DecimateJunction(double width, const Monitor& monitor)
  {
    const double error = this->Effective.MaximumError;
    JunctionInput junction;
    junction.EditZone = this->Between(this->Bottom - this->BelowWidth, this->Bottom + width);
    const std::set<Index>& points = this->Growing.Junction();
    if (points.empty())
    {
      return;
    }
    const double reach = JunctionReach(error);
    GrowingSurface::Strip strip = this->Growing.Take(
      this->Between(junction.EditZone.Low - reach, junction.EditZone.High + reach));
    junction.IsFinished = FarFromJunction(strip, points);
    junction.Original = Joined(std::move(this->Below), this->Above);
    junction.Strip = std::move(strip.Piece);
    this->Figures.Junctions += 1;
    this->Figures.JunctionTriangles +=
      static_cast<std::int64_t>(junction.Strip.Shape.Triangles.size());
    JunctionResult made = bonedecimate::DecimateJunction(
      junction, this->Effective, this->Source(), this->Inputs.InputIsSingle, monitor);
    this->TakeJunction(junction, strip, made);
    this->Growing.Finish(this->Between(this->Bottom, Infinity));
  }

  /// Of each point of the strip, whether its component has no point of the junction: slabs have finished it.
  static std::vector<char> FarFromJunction(
    const GrowingSurface::Strip& strip, const std::set<Index>& junction)
  {
    const Components found = FindComponents(strip.Piece.Shape);
    std::vector<char> hasJunction(static_cast<std::size_t>(found.Count), 0);
    for (std::size_t i = 0; i < strip.Points.size(); ++i)
    {
      hasJunction[found.OfPoint[i]] |= junction.count(strip.Points[i]) != 0 ? 1 : 0;
    }
    std::vector<char> isFar;
    for (const Index component : found.OfPoint)
    {
      isFar.push_back(hasJunction[component] != 0 ? 0 : 1);
    }
    return isFar;
  }

  void TakeJunction(
    JunctionInput& junction, const GrowingSurface::Strip& strip, JunctionResult& made)
  {
    const Report& report = made.Run.Report;
    const bool isGood = report.Status == InputStatus::Good && made.Proof != ProofStatus::Violated &&
      made.Proof != ProofStatus::Undecided;
    if (isGood && report.Stop == StopReason::Aborted)
    {
      this->Fail(SlabStatus::Aborted, "The run was aborted.");
    }
    if (isGood)
    {
      this->Totals.AddJunction(report);
      if (this->Effective.ProveResult)
      {
        this->AddProof(
          this->Proof.WasMade, made.Proof, made.OriginalToResult, made.ResultToOriginal);
      }
      junction.Strip = { std::move(made.Run.Surface), std::move(made.Run.BoundaryLabels) };
    }
    this->Figures.UnprovedJunctions += isGood ? 0 : 1;
    this->Figures.JunctionTrianglesLeft +=
      static_cast<std::int64_t>(junction.Strip.Shape.Triangles.size());
    this->Growing.PutBack(strip, junction.Strip);
  }

  double Slack = 0.0; // mm
  double Bottom;      // mm, of the next slab
  bool HasSlabBelow = false;
  double BelowWidth = 0.0; // mm, of the zone below the plane
  double Width = 0.0;      // mm, of the zones in the last slab
  SurfacePiece Below;      // the original below the plane
  SurfacePiece Above;
  SurfacePiece Next; // below the next plane
  GrowingSurface Growing;
  ErrorProof Proof;
  std::optional<Slab> Waiting; // too thin to be run alone
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
  return this->Run->Add(std::move(slab), false, monitor);
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
