// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Overlay.h"

#include "ColorFunction.h"

#include "vtkActor2D.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
constexpr std::array<double, 3> Ink = { 0.13, 0.14, 0.16 };
constexpr std::array<double, 3> QuietInk = { 0.36, 0.38, 0.41 };
constexpr std::array<double, 3> MarkInk = { 0.07, 0.34, 0.69 };
constexpr std::array<double, 3> White = { 1.0, 1.0, 1.0 };
constexpr double Radius = 0.017; // of a ring, in heights of the window

void SetLook(vtkTextProperty* property, int pixels, bool isBold, bool isQuiet)
{
  const auto& color = isQuiet ? QuietInk : Ink;
  property->SetFontFamilyToArial();
  property->SetFontSize(pixels);
  property->SetBold(isBold);
  property->SetItalic(false);
  property->SetShadow(false);
  property->SetColor(color[0], color[1], color[2]);
}
}

Overlay::Overlay(vtkRenderWindow* window)
  : Window(window)
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
{
  window->SetNumberOfLayers(2);
  this->Renderer->SetLayer(1);
  this->Renderer->InteractiveOff();
  window->AddRenderer(this->Renderer);
}

int Overlay::Pixels(double heights) const
{
  return std::max(1, static_cast<int>(std::lround(heights * this->Window->GetSize()[1])));
}

void Overlay::Write(const Words& words)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(words.Text.c_str());
  vtkTextProperty* property = actor->GetTextProperty();
  SetLook(property, this->Pixels(words.Size), words.IsBold, words.IsQuiet);
  property->SetJustification(static_cast<int>(words.Side)); // Align has VTK's order
  property->SetVerticalJustificationToCentered();
  if (words.IsMark)
  {
    property->SetColor(MarkInk[0], MarkInk[1], MarkInk[2]);
    property->SetBackgroundColor(White[0], White[1], White[2]);
    property->SetBackgroundOpacity(0.85);
  }
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(words.At[0], words.At[1]);
  this->Renderer->AddViewProp(actor);
}

void Overlay::Draw(const std::vector<Position>& line, double width)
{
  this->Draw(line, width, Ink);
}

void Overlay::Draw(const std::vector<Position>& line, double width, const Color& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<int>(line.size()));
  for (const Position& position : line)
  {
    lines->InsertCellPoint(points->InsertNextPoint(position[0], position[1], 0.0));
  }
  vtkNew<vtkPolyData> drawing;
  drawing->SetPoints(points);
  drawing->SetLines(lines);
  vtkNew<vtkCoordinate> coordinate;
  coordinate->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(drawing);
  mapper->SetTransformCoordinate(coordinate);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(static_cast<float>(this->Pixels(width)));
  this->Renderer->AddViewProp(actor);
}

void Overlay::DrawRectangle(const Position& lowerLeft, const Position& upperRight, double width)
{
  this->Draw({ lowerLeft, { upperRight[0], lowerLeft[1] }, upperRight,
               { lowerLeft[0], upperRight[1] }, lowerLeft },
    width);
}

void Overlay::DrawRing(const Position& middle, const std::string& words)
{
  constexpr int corners = 48;
  const int* size = this->Window->GetSize();
  const double across = Radius * size[1] / size[0];
  std::vector<Position> ring;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / corners;
    ring.push_back({ middle[0] + across * std::cos(angle), middle[1] + Radius * std::sin(angle) });
  }
  this->Draw(ring, 0.006, White);
  this->Draw(ring, 0.003, MarkInk);
  this->Write({ words, { middle[0] + 1.3 * across, middle[1] + 1.3 * Radius }, 0.02, Align::Left,
    true, false, true });
}

void Overlay::DrawColorBar(const Position& lowerLeft, const Position& upperRight,
  const ColorScale& scale, const std::string& title)
{
  vtkNew<vtkScalarBarActor> bar;
  // With a tolerance to twice that, so that it has a number of its own.
  const bool hasTolerance = scale.Tolerance > 0.0;
  bar->SetLookupTable(
    MakeColorFunction({ hasTolerance ? 2.0 * scale.Tolerance : scale.Range, scale.Tolerance }));
  bar->SetMaximumNumberOfColors(256);
  bar->SetOrientationToHorizontal();
  bar->SetNumberOfLabels(hasTolerance ? 3 : 5);
  bar->SetLabelFormat("%g");
  const double height = 0.68 * (upperRight[1] - lowerLeft[1]);
  bar->SetPosition(lowerLeft[0], lowerLeft[1]);
  bar->SetPosition2(upperRight[0] - lowerLeft[0], height);
  bar->UnconstrainedFontSizeOn();
  bar->SetTextPositionToPrecedeScalarBar(); // below a horizontal one
  bar->SetBarRatio(0.42);
  SetLook(bar->GetLabelTextProperty(), this->Pixels(0.019), false, false);
  this->Renderer->AddViewProp(bar);
  const double middle = 0.5 * (lowerLeft[0] + upperRight[0]);
  this->Write({ title, { middle, upperRight[1] - 0.16 * (upperRight[1] - lowerLeft[1]) }, 0.021,
    Align::Center, true });
}
}
