// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComposedPicture.h"

#include "BoneView.h"
#include "DistanceColors.h"
#include "FarthestPoints.h"
#include "NamedLabels.h"
#include "NumberText.h"
#include "Overlay.h"
#include "ReportFields.h"
#include "SurfaceDistances.h"
#include "Viewpoint.h"

#include "vtkAppendPolyData.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
// The picture from top to bottom, in fractions of the window: headline, captions, the whole bone, a
// line of words, the close-ups, the footer with the color bar.
constexpr double TitleHeight = 0.055;
constexpr double CaptionHeight = 0.048;
constexpr double WholeBottom = 0.445;
constexpr double BetweenRows = 0.425;
constexpr double CloseUpTop = 0.405;
constexpr double FooterHeight = 0.105;
constexpr double Gap = 0.006;
constexpr int Columns = 3;

constexpr double EdgesAcross = 18.0;      // of the result's triangles in a close-up
constexpr double NarrowestCloseUp = 0.05; // of the height of the whole view
constexpr double WidestCloseUp = 0.22;

/// The two cameras and the two rows they are for.
struct Rows
{
  Viewpoint View;
  Frame Whole;
  Frame CloseUp;
  vtkSmartPointer<vtkPlane> Cut; ///< Before the mark in the close-up; may be null.
};

struct Distances
{
  vtkDataArray* Array = nullptr; ///< Null if there are none: the third column then stays bare.
  ColorScale Scale;
  double Largest = 0.0; ///< mm
};

Area ViewArea(int column, bool isWhole, bool hasTitle)
{
  const double width = (1.0 - (Columns + 1) * Gap) / Columns;
  const double left = Gap + column * (width + Gap);
  const double top = 1.0 - (hasTitle ? TitleHeight : 0.0) - CaptionHeight;
  return isWhole ? Area{ { left, WholeBottom }, { left + width, top } }
                 : Area{ { left, FooterHeight }, { left + width, CloseUpTop } };
}

/// @param surface That of the third column.
Distances FindDistances(vtkPolyData* surface, const PictureSubject& subject)
{
  Distances distances;
  distances.Array = surface->GetPointData()->GetArray(subject.DistanceArrayName.c_str());
  const std::vector<double> sorted = SortedDistances(surface, subject.DistanceArrayName);
  distances.Scale = subject.Tolerance > 0.0 ? ScaleOfTolerance(subject.Tolerance)
                                            : ColorScale{ ColorRange(sorted) };
  const double largest = sorted.empty() ? 0.0 : sorted.back();
  distances.Largest = std::max(largest, subject.LargestDistance);
  return distances;
}

Rows ChooseRows(
  vtkRenderWindow* window, vtkPolyData* before, vtkPolyData* after, vtkDataArray* distances)
{
  Rows rows;
  rows.View = ChooseViewpoint(before, distances);
  rows.Whole = FrameWhole(rows.View, before, ViewArea(0, true, true).Aspect(window));
  const double height = 2.0 * rows.Whole.HalfHeight;
  const double width =
    std::clamp(EdgesAcross * TypicalEdge(after), NarrowestCloseUp * height, WidestCloseUp * height);
  rows.CloseUp = FrameCloseUp(rows.View, before, distances, width);
  return rows;
}

std::array<double, 3> Moved(
  const std::array<double, 3>& point, double length, const std::array<double, 3>& direction)
{
  return { point[0] + length * direction[0], point[1] + length * direction[1],
    point[2] + length * direction[2] };
}

/// Turns both rows to a marked point and the close-up upon it. @param marked Its surface.
void TurnTo(const PictureMark& mark, vtkPolyData* before, vtkPolyData* after, vtkPolyData* marked,
  double aspect, Rows& rows)
{
  const PointView seen = ChooseViewOfPoint(rows.View, marked, mark.Position);
  vtkNew<vtkAppendPolyData> both; // the point may lie where the other surface has nothing
  both->AddInputData(before);
  both->AddInputData(after);
  both->Update();
  rows.View = seen.View;
  rows.Whole = FrameWhole(rows.View, both->GetOutput(), aspect);
  const double least = NarrowestCloseUp * rows.Whole.HalfHeight;
  rows.CloseUp.HalfHeight =
    std::min(rows.CloseUp.HalfHeight, std::max(least, 0.5 * mark.MostWidth));
  const double outside = both->GetOutput()->GetLength();
  rows.CloseUp.Center = Moved(mark.Position, outside, rows.View.ToViewer);
  if (std::isfinite(seen.Free))
  {
    rows.Cut = vtkSmartPointer<vtkPlane>::New();
    rows.Cut->SetOrigin(Moved(mark.Position, 0.5 * seen.Free, rows.View.ToViewer).data());
    rows.Cut->SetNormal(Moved({ 0.0, 0.0, 0.0 }, -1.0, rows.View.ToViewer).data());
  }
}

/// "Before: 1,234 triangles"
std::string CountCaption(const PictureSubject& subject, std::size_t surface, vtkPolyData* drawn)
{
  const auto count = static_cast<double>(drawn->GetNumberOfPolys());
  return subject.Names[surface] + ": " + GroupedText(subject.Triangles[surface].value_or(count)) +
    " triangles";
}

void WriteCaptions(Overlay& overlay, const std::vector<std::string>& captions, bool hasTitle)
{
  for (int column = 0; column < Columns; ++column)
  {
    const Area area = ViewArea(column, true, hasTitle);
    const double middle = 0.5 * (area.LowerLeft[0] + area.UpperRight[0]);
    overlay.Write({ captions[static_cast<std::size_t>(column)],
      { middle, area.UpperRight[1] + 0.5 * CaptionHeight }, 0.024, Align::Center, true });
  }
}

/// Where a point of space lies in an area that shows a frame.
Position PositionInArea(
  const Area& area, double aspect, const Rows& rows, const std::array<double, 3>& point)
{
  std::array<double, 3> offset;
  vtkMath::Subtract(point, rows.Whole.Center, offset);
  const double right = vtkMath::Dot(offset, rows.View.Right) / (rows.Whole.HalfHeight * aspect);
  const double up = vtkMath::Dot(offset, rows.View.Up) / rows.Whole.HalfHeight;
  return { area.LowerLeft[0] + 0.5 * (1.0 + right) * (area.UpperRight[0] - area.LowerLeft[0]),
    area.LowerLeft[1] + 0.5 * (1.0 + up) * (area.UpperRight[1] - area.LowerLeft[1]) };
}

/// Draws a frame around the close-up in a view of the whole bone.
void MarkCloseUp(
  Overlay& overlay, vtkRenderWindow* window, int column, const Rows& rows, bool hasTitle)
{
  const Area area = ViewArea(column, true, hasTitle);
  const Position middle = PositionInArea(area, area.Aspect(window), rows, rows.CloseUp.Center);
  const double scale = 0.5 * rows.CloseUp.HalfHeight / rows.Whole.HalfHeight;
  const double up = scale * (area.UpperRight[1] - area.LowerLeft[1]);
  const double closeUpAspect = ViewArea(column, false, hasTitle).Aspect(window);
  const double right = up * closeUpAspect * window->GetSize()[1] / window->GetSize()[0];
  overlay.DrawRectangle(
    { std::max(middle[0] - right, area.LowerLeft[0]), std::max(middle[1] - up, area.LowerLeft[1]) },
    { std::min(middle[0] + right, area.UpperRight[0]),
      std::min(middle[1] + up, area.UpperRight[1]) });
}

/// A line of a readable length in the lower left of an area.
void DrawScale(Overlay& overlay, vtkRenderWindow* window, const Area& area, const Frame& frame)
{
  const double widthShown = 2.0 * frame.HalfHeight * area.Aspect(window);
  const double length = RoundUp(0.12 * widthShown, { 1.0, 2.0, 5.0 });
  const double width = length / widthShown * (area.UpperRight[0] - area.LowerLeft[0]);
  const Position left = { area.LowerLeft[0] + 0.008, area.LowerLeft[1] + 0.014 };
  overlay.Draw({ left, { left[0] + width, left[1] } }, 0.004);
  overlay.Write({ ShortText(length) + " mm", { left[0] + width + 0.006, left[1] }, 0.018 });
}

/// The ends of x and z, for a view along y.
void WriteDirections(Overlay& overlay, const Area& area, const std::string& frame)
{
  const auto letters = AxisLetters(frame);
  const double middle = 0.5 * (area.LowerLeft[0] + area.UpperRight[0]);
  const double height = 0.5 * (area.LowerLeft[1] + area.UpperRight[1]);
  overlay.Write(
    { letters[0][0], { area.LowerLeft[0] + 0.006, height }, 0.018, Align::Left, false, true });
  overlay.Write(
    { letters[0][1], { area.UpperRight[0] - 0.006, height }, 0.018, Align::Right, false, true });
  overlay.Write(
    { letters[2][1], { middle, area.UpperRight[1] - 0.016 }, 0.018, Align::Center, false, true });
  overlay.Write(
    { letters[2][0], { middle, area.LowerLeft[1] + 0.016 }, 0.018, Align::Center, false, true });
}

void WriteCloseUpCaption(Overlay& overlay, vtkRenderWindow* window, const Rows& rows)
{
  const Area area = ViewArea(0, false, true);
  const double width = 2.0 * rows.CloseUp.HalfHeight * area.Aspect(window);
  overlay.Write({ "Close-up: the framed area with its triangles, " +
      ShortText(std::round(10.0 * width) / 10.0) + " mm wide" +
      (rows.Cut ? "; what hides the ring is cut away" : ""),
    { area.LowerLeft[0] + 0.002, BetweenRows }, 0.02, Align::Left, true });
}

/// Where a camera is, in words.
std::string CameraText(const Viewpoint& view, const std::string& frame)
{
  constexpr double least = 0.45;           // of a direction that counts
  using Ends = std::array<std::string, 2>; // the lower one first
  const std::array<Ends, 2> ends = frame == "LPS"
    ? std::array<Ends, 2>{ { { "the right", "the left" }, { "the front", "the back" } } }
    : frame == "RAS"
    ? std::array<Ends, 2>{ { { "the left", "the right" }, { "the back", "the front" } } }
    : std::array<Ends, 2>{ { { "the side of -x", "the side of x" },
        { "the side of -y", "the side of y" } } };
  std::string text;
  for (const std::size_t axis : { 1, 0 })
  {
    const double along = view.ToViewer[axis];
    if (std::abs(along) > least)
    {
      text += (text.empty() ? "" : " and ") + ends[axis][along < 0.0 ? 0 : 1];
    }
  }
  const double up = view.ToViewer[2];
  return text +
    (up < 0.0      ? ", from below."
        : up > 0.5 ? ", from above."
                   : ", a little from above.");
}

void WriteFooter(
  Overlay& overlay, const Distances& distances, const Viewpoint& view, const std::string& frame)
{
  std::vector<std::string> lines = { "The camera is the same along each row. Seen from " +
    CameraText(view, frame) };
  if (distances.Array && distances.Scale.Tolerance > 0.0)
  {
    lines.push_back("Distances above the tolerance of " + ShortText(distances.Scale.Tolerance) +
      " mm have the last color.");
  }
  else if (distances.Array && distances.Largest > distances.Scale.Range)
  {
    lines.push_back("Colors end at " + ShortText(distances.Scale.Range) +
      " mm; the few larger distances have the last color.");
  }
  lines.push_back("This software is not a medical device.");
  Position at = { ViewArea(0, false, true).LowerLeft[0] + 0.002, 0.074 };
  for (const std::string& line : lines)
  {
    overlay.Write({ line, at, 0.017, Align::Left, false, true });
    at[1] -= 0.026;
  }
}

std::string DistanceCaption(const Distances& distances, const PictureSubject& subject)
{
  const std::string largest =
    subject.Mark ? subject.Mark->Largest : MeasuredText(distances.Largest);
  return distances.Array ? "Distance, largest " + largest + " mm" : "Distance not measured";
}

bool WasSmoothed(vtkPolyData* after)
{
  return ReportFields(after).Number("smoothing.largest_displacement").has_value();
}

/// Whether the third column has the result: the surface of the mark.
bool ShowsAfter(const PictureSubject& subject)
{
  return subject.Mark && !subject.Mark->IsOnBefore;
}

/// The frames of the close-ups and, if there is a mark, a ring in each of them.
void MarkViews(
  Overlay& overlay, vtkRenderWindow* window, const Rows& rows, const PictureSubject& subject)
{
  const bool hasTitle = !subject.Title.empty();
  for (int column = 0; column < Columns; ++column)
  {
    MarkCloseUp(overlay, window, column, rows, hasTitle);
    if (subject.Mark)
    {
      const Area area = ViewArea(column, false, hasTitle);
      overlay.DrawRing({ 0.5 * (area.LowerLeft[0] + area.UpperRight[0]),
                         0.5 * (area.LowerLeft[1] + area.UpperRight[1]) },
        subject.Mark->Words);
    }
  }
}

std::string BarTitle(const PictureSubject& subject)
{
  return subject.Tolerance > 0.0
    ? (ShowsAfter(subject) ? "to the reference, mm; tolerance " : "to the result, mm; tolerance ") +
      ShortText(subject.Tolerance)
    : ShowsAfter(subject) ? "distance to the reference, mm"
                          : "distance to the result, mm";
}

void AddViews(vtkRenderWindow* window, vtkPolyData* before, vtkPolyData* after, const Rows& rows,
  const Distances& distances, const PictureSubject& subject)
{
  const bool hasTitle = !subject.Title.empty();
  const double lineWidth = std::max(1.0, window->GetSize()[1] / 1400.0);
  const bool isSmoothed = WasSmoothed(subject.After);
  const std::vector<NamedLabel> labels = LabelsOf(subject.After);
  for (int column = 0; column < Columns; ++column)
  {
    vtkPolyData* surface = column == 1 || (column == 2 && ShowsAfter(subject)) ? after : before;
    const auto bone = MakeBone(surface);
    const auto closeUp = MakeBone(surface);
    if (column < 2)
    {
      ColorByLabel(bone, labels);
      ColorByLabel(closeUp, labels);
      if (isSmoothed)
      {
        ShadeFlat(bone);
      }
      ShowTriangles(closeUp, lineWidth);
    }
    else if (distances.Array)
    {
      ColorByDistance(bone, subject.DistanceArrayName, distances.Scale);
      ColorByDistance(closeUp, subject.DistanceArrayName, distances.Scale);
    }
    if (rows.Cut)
    {
      closeUp->GetMapper()->AddClippingPlane(rows.Cut);
    }
    AddView(window, ViewArea(column, true, hasTitle), bone, rows.View, rows.Whole);
    AddView(window, ViewArea(column, false, hasTitle), closeUp, rows.View, rows.CloseUp);
  }
}
}

void ComposePicture(vtkRenderWindow* window, const PictureSubject& subject)
{
  const bool hasTitle = !subject.Title.empty();
  const auto before = TrianglesWithNormals(subject.Before);
  const auto after = TrianglesWithNormals(subject.After);
  vtkPolyData* const third = ShowsAfter(subject) ? after : before;
  const Distances distances = FindDistances(third, subject);
  Rows rows = ChooseRows(
    window, before, after, before->GetPointData()->GetArray(subject.DistanceArrayName.c_str()));
  if (subject.Mark)
  {
    TurnTo(*subject.Mark, before, after, third, ViewArea(0, true, true).Aspect(window), rows);
  }
  AddBackdrop(window);
  AddViews(window, before, after, rows, distances, subject);

  Overlay overlay(window);
  if (hasTitle)
  {
    overlay.Write({ subject.Title, { 0.5, 1.0 - 0.5 * TitleHeight }, 0.03, Align::Center, true });
  }
  WriteCaptions(overlay,
    { CountCaption(subject, 0, before), CountCaption(subject, 1, after),
      DistanceCaption(distances, subject) },
    hasTitle);
  MarkViews(overlay, window, rows, subject);
  DrawScale(overlay, window, ViewArea(0, true, hasTitle), rows.Whole);
  WriteCloseUpCaption(overlay, window, rows);
  if (!subject.Frame.empty())
  {
    WriteDirections(overlay, ViewArea(0, true, hasTitle), subject.Frame);
  }
  WriteFooter(overlay, distances, rows.View, subject.Frame);
  if (distances.Array)
  {
    const Area area = ViewArea(2, false, hasTitle);
    overlay.DrawColorBar({ area.LowerLeft[0] + 0.02, 0.005 },
      { area.UpperRight[0] - 0.02, FooterHeight - 0.01 }, distances.Scale, BarTitle(subject));
  }
}
}
