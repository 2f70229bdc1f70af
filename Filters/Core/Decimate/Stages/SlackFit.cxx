// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SlackFit.h"

#include "FanSearch.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Distance of points on the edges of the fan, in mean edges of the original.
constexpr double SpacingInEdges = 0.35;
/// Moved vertices lie on a grid with steps of a mean edge divided by this power of two.
constexpr double GridBits = 20.0;
constexpr int MaxPoints = 10; // segments of an edge of the fan
/// The longest step, in mean edges at the vertex.
constexpr double LongestStep = 0.4;
/// Attempts to lower the error by a step, each by this fraction of the previous one.
constexpr int Attempts = 3;
constexpr double NextAttempt = 0.35;
/// The relative decrease of the error that a step must reach.
constexpr double MinGain = 1e-4;
/// Rows below this fraction of the largest ratio hardly matter to the step.
constexpr double MinRatio = 0.4;
/// The fraction of the area around a vertex that the vertex represents. The distance rises between
/// the vertex and the nearest samples, so without this term it could leave the bound.
constexpr double VertexFraction = 0.1;
constexpr int StepsOfExponent = 4;

double SixteenthPower(double ratio)
{
  const double square = ratio * ratio;
  const double fourth = square * square;
  return fourth * fourth * fourth * fourth;
}
}

SlackFit::SlackFit(const Editor& editor, const Samples& samples, const OriginalHints& hints)
  : MeshEditor(editor)
  , OriginalSamples(samples)
  , Hints(hints)
  , Tree(editor.Original().BoundedTree())
  , Spacing(SpacingInEdges * editor.Original().BoundedMesh().InitialEdgeLength())
  , Grid(std::exp2(
      std::floor(std::log2(editor.Original().BoundedMesh().InitialEdgeLength())) - GridBits))
{
}

//------------------------------------------------------------------------------
void SlackFit::Clear()
{
  this->Spokes.clear();
  this->SampleMembers.clear();
}

//------------------------------------------------------------------------------
void SlackFit::AddFace(const Vector3& second, const Vector3& third)
{
  this->Spokes.push_back({ second, third });
}

//------------------------------------------------------------------------------
void SlackFit::AddSamples(FaceId face, std::size_t slot)
{
  const TriangleFrame frame = FrameOf(this->MeshEditor.Mesh(), face);
  for (Index s = this->OriginalSamples.First(face); s != None; s = this->OriginalSamples[s].Next)
  {
    const double limit = this->OriginalSamples[s].Limit;
    const double squared =
      frame.Nearest(this->OriginalSamples.SamplePosition(this->OriginalSamples[s])).SquaredDistance;
    this->SampleMembers.push_back({ s, slot, squared <= limit * limit });
  }
}

//------------------------------------------------------------------------------
void SlackFit::Build(const Vector3& x)
{
  this->Frames.clear();
  double length = 0.0;
  double area = 0.0; // mm^2
  for (const Spoke& spoke : this->Spokes)
  {
    this->Frames.emplace_back(x, spoke.Second, spoke.Third);
    length += (spoke.Second - x).norm();
    area += this->Frames.back().SurfaceArea();
  }
  const double unit = this->MeshEditor.Mesh().Unit();
  this->RingArea = area / (unit * unit);
  this->MaxStep = LongestStep * length / static_cast<double>(this->Spokes.size());
}

//------------------------------------------------------------------------------
/// @param perDistance The change of the distance with a step of the vertex.
void SlackFit::AddRow(double weight, double distance, double limit, const Vector3& perDistance)
{
  if (distance > 0.0 || limit > 0.0)
  {
    const double ratio = distance / limit;
    this->CurrentValue.Error += weight * SixteenthPower(ratio);
    this->CurrentValue.MaxRatio = std::max(this->CurrentValue.MaxRatio, ratio);
    if (limit > 0.0)
    {
      this->Rows.push_back({ weight, ratio, perDistance / limit });
    }
  }
}

//------------------------------------------------------------------------------
bool SlackFit::AddSampleRows(double enough)
{
  for (Member& member : this->SampleMembers)
  {
    const Samples::Sample& sample = this->OriginalSamples[member.Sample];
    const Vector3 p = this->OriginalSamples.SamplePosition(sample);
    const TriangleFrame::Point nearest = FindInWholeFan(this->Frames, p, member.Slot);
    if (!member.IsCounted)
    {
      continue;
    }
    const TriangleFrame& frame = this->Frames[member.Slot];
    const double distance = std::sqrt(nearest.SquaredDistance);
    const Vector3 way = p - frame.At(nearest);
    const double fraction = 1.0 - nearest.B - nearest.C;
    const Vector3 direction = distance > 0.0 ? Vector3(way / distance) : frame.UnitNormal();
    const double limit = std::min<double>(sample.Limit, this->OriginalSamples.MaxLimit());
    this->AddRow(sample.Weight, distance, limit, -fraction * direction);
    if (!(this->CurrentValue.Error < enough))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double SlackFit::LimitOver(Index triangle) const
{
  const Triangle c = this->Hints.Original().Corners(triangle);
  const ErrorBound& bound = *this->MeshEditor.Bound();
  return std::min({ bound.LimitAt(c[0]), bound.LimitAt(c[1]), bound.LimitAt(c[2]),
    static_cast<double>(this->OriginalSamples.MaxLimit()) });
}

//------------------------------------------------------------------------------
/// @param fraction Weight of the vertex in the point.
PointOnMesh SlackFit::AddPointRow(const Vector3& p, Index hint, double fraction, double weight)
{
  PointOnMesh found = WalkFrom(this->Hints.Original(), p, hint);
  TriangleFrame frame = FrameOf(this->Hints.Original(), found.Face);
  const double limit = this->LimitOver(found.Face);
  if (found.Point.SquaredDistance > limit * limit) // the walk may have stopped on another part
  {
    found.Face = this->Tree.FindNearest(p, found.Face).Triangle;
    frame = FrameOf(this->Hints.Original(), found.Face);
    found.Point = frame.Nearest(p);
  }
  const double distance = std::sqrt(found.Point.SquaredDistance);
  const Vector3 direction =
    distance > 0.0 ? Vector3((p - frame.At(found.Point)) / distance) : frame.UnitNormal();
  this->AddRow(weight, distance, this->LimitOver(found.Face), fraction * direction);
  return found;
}

//------------------------------------------------------------------------------
/// Adds points on the edges of the vertex, where faces are farthest from the original between its
/// vertices, and a point inside of each face.
bool SlackFit::AddFaceRows(const Vector3& x, double enough, std::size_t firstSpoke)
{
  constexpr double third = 1.0 / 3.0;
  const double unit = this->MeshEditor.Mesh().Unit();
  const Index atVertex = this->CurrentValue.Hint;
  for (std::size_t face = 0; face < this->Spokes.size() && this->CurrentValue.Error < enough;
       ++face)
  {
    const Spoke& spoke = this->Spokes[face];
    const double weight = this->Frames[face].SurfaceArea() / (unit * unit);
    const int count = static_cast<int>(std::clamp(
      std::ceil((spoke.Second - x).norm() / this->Spacing), 2.0, static_cast<double>(MaxPoints)));
    Index hint = atVertex;
    for (int i = face < firstSpoke ? 0 : count - 1; i > 0; --i)
    {
      const double fraction = static_cast<double>(i) / count;
      const Vector3 p = fraction * x + (1.0 - fraction) * spoke.Second;
      hint = this->AddPointRow(p, hint, fraction, weight / count).Face;
    }
    this->AddPointRow(third * (x + spoke.Second + spoke.Third), atVertex, third, third * weight);
  }
  return this->CurrentValue.Error < enough;
}

//------------------------------------------------------------------------------
SlackFit::Value SlackFit::Evaluate(const Vector3& x, Index hint, double enough)
{
  this->Build(x);
  this->Rows.clear();
  this->CurrentValue = { 0.0, 0.0, hint };
  const Value ended{ Infinity, Infinity, hint };
  if (!this->AddSampleRows(enough))
  {
    return ended;
  }
  if (this->Terms == ErrorTerms::All)
  {
    this->CurrentValue.Hint = this->AddPointRow(x, hint, 1.0, VertexFraction * this->RingArea).Face;
    if (!this->AddFaceRows(x, enough, 0))
    {
      return ended;
    }
  }
  return this->CurrentValue;
}

//------------------------------------------------------------------------------
SlackFit::Value SlackFit::EvaluatePair(const Vector3& x, Index hint, double enough)
{
  this->Build(x);
  this->Rows.clear();
  this->CurrentValue = { 0.0, 0.0, hint };
  return this->AddSampleRows(enough) && this->AddFaceRows(x, enough, 1)
    ? this->CurrentValue
    : Value{ Infinity, Infinity, hint };
}

//------------------------------------------------------------------------------
double SlackFit::MaxRatioOfSamples(const Vector3& x, double maxRatio)
{
  this->Build(x);
  double largest = 0.0; // squared
  for (Member& member : this->SampleMembers)
  {
    const Samples::Sample& sample = this->OriginalSamples[member.Sample];
    const double squared =
      FindInWholeFan(this->Frames, this->OriginalSamples.SamplePosition(sample), member.Slot)
        .SquaredDistance;
    const double limit = std::min<double>(sample.Limit, this->OriginalSamples.MaxLimit());
    if (!member.IsCounted)
    {
      continue;
    }
    largest = squared > 0.0 ? std::max(largest, squared / (limit * limit)) : largest;
    if (largest > maxRatio * maxRatio)
    {
      return Infinity;
    }
  }
  return std::sqrt(largest);
}

//------------------------------------------------------------------------------
/// Ratios are divided by the largest one, so that powers stay in range.
Vector3 SlackFit::Step() const
{
  std::vector<Row> active;
  const double largest = this->CurrentValue.MaxRatio;
  if (!(largest > 0.0 && largest < Infinity))
  {
    return Vector3::Zero(); // infinite where the limit is 0
  }
  for (const Row& row : this->Rows)
  {
    if (row.Ratio > MinRatio * largest)
    {
      active.push_back({ row.Weight, row.Ratio / largest, row.Gradient / largest });
    }
  }
  Vector3 x = Vector3::Zero();
  for (const int exponent : { 4, 8, 16 })
  {
    for (int i = 0; i < StepsOfExponent; ++i)
    {
      x += this->NewtonStep(active, x, exponent);
      const double length = x.norm();
      x *= length > this->MaxStep ? this->MaxStep / length : 1.0;
    }
  }
  return x.allFinite() ? x : Vector3(Vector3::Zero());
}

//------------------------------------------------------------------------------
Vector3 SlackFit::NewtonStep(const std::vector<Row>& rows, const Vector3& x, int exponent) const
{
  constexpr double damping = 1e-3; // of the trace
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Vector3 first = Vector3::Zero();
  for (const Row& row : rows)
  {
    const double ratio = row.Ratio + Dot(row.Gradient, x);
    const double square = ratio * ratio;
    double power = square; // ratio^(exponent - 2)
    if (exponent > 4)
    {
      const double fourth = square * square;
      power *= exponent == 8 ? fourth : fourth * fourth * fourth;
    }
    const Vector3 scaled = row.Weight * power * row.Gradient;
    first += ratio * scaled;
    second += (exponent - 1) * scaled * row.Gradient.transpose();
  }
  const double trace = second.trace();
  if (!(trace > 0.0))
  {
    return Vector3::Zero();
  }
  second += damping * trace * Eigen::Matrix3d::Identity();
  return -(second.inverse() * first);
}

//------------------------------------------------------------------------------
Vector3 SlackFit::OnGrid(const Vector3& x) const
{
  return this->Grid > 0.0 ? Vector3((x / this->Grid).array().round() * this->Grid) : x;
}

//------------------------------------------------------------------------------
SlackFit::Value SlackFit::TryStep(Vector3& x, const Value& before)
{
  const double enough = (1.0 - MinGain) * before.Error;
  Vector3 step = this->Step();
  for (int attempt = 0; attempt < Attempts; ++attempt, step *= NextAttempt)
  {
    const Vector3 moved = this->OnGrid(x + step);
    const Value after = this->Evaluate(moved, before.Hint, enough);
    if (after.Error < enough)
    {
      x = moved;
      return after;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
SlackFit::Value SlackFit::Improve(Vector3& x, Index hint, int times)
{
  Value best = this->Evaluate(x, hint);
  for (int i = 0; i < times && best.MaxRatio > 0.0 && best.MaxRatio < Infinity; ++i)
  {
    const Value next = this->TryStep(x, best);
    if (!(next.Error < best.Error))
    {
      break;
    }
    best = next;
  }
  return best;
}
}
