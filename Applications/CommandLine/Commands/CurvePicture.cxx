// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CurvePicture.h"

#include "Base/Text.h"
#include "NumberText.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
// The drawing in its own units.
constexpr double Width = 640.0;
constexpr double Height = 420.0;
constexpr double Left = 80.0;
constexpr double Right = 610.0;
constexpr double Top = 44.0;
constexpr double Bottom = 350.0;
/// Between the outermost points and the frame, in powers of ten.
constexpr double Margin = 0.08;

/// One axis, in powers of ten.
struct Axis
{
  double From = 0.0; // logarithms
  double To = 1.0;
  double Begin = 0.0; // in the drawing
  double End = 0.0;

  double At(double value) const
  {
    return this->Begin +
      (std::log10(value) - this->From) / (this->To - this->From) * (this->End - this->Begin);
  }
};

Axis AxisOf(double least, double largest, double begin, double end)
{
  return { std::log10(least) - Margin, std::log10(largest) + Margin, begin, end };
}

/// 1, 2 and 5 times the powers of ten that lie on it.
std::vector<double> Ticks(const Axis& axis)
{
  std::vector<double> ticks;
  for (double power = std::floor(axis.From); power <= axis.To; power += 1.0)
  {
    for (const double step : { 1.0, 2.0, 5.0 })
    {
      const double value = step * std::pow(10.0, power);
      if (std::log10(value) >= axis.From && std::log10(value) <= axis.To)
      {
        ticks.push_back(value);
      }
    }
  }
  return ticks;
}

std::string Number(double value)
{
  std::string text = GroupedText(value, 1);
  text.erase(std::remove(text.begin(), text.end(), ','), text.end());
  return text;
}

std::string Text(double x, double y, const std::string& anchor, const std::string& text)
{
  return "<text x=\"" + Number(x) + "\" y=\"" + Number(y) + "\" text-anchor=\"" + anchor + "\">" +
    EscapedXml(text) + "</text>\n";
}

std::string Line(double x1, double y1, double x2, double y2)
{
  return "<line x1=\"" + Number(x1) + "\" y1=\"" + Number(y1) + "\" x2=\"" + Number(x2) +
    "\" y2=\"" + Number(y2) + "\"/>\n";
}

std::string Grid(const Axis& errors, const Axis& triangles)
{
  std::string svg = "<g stroke=\"#ccc\">\n";
  std::string words;
  for (const double tick : Ticks(errors))
  {
    svg += Line(errors.At(tick), Top, errors.At(tick), Bottom);
    words += Text(errors.At(tick), Bottom + 20.0, "middle", ShortText(tick));
  }
  for (const double tick : Ticks(triangles))
  {
    svg += Line(Left, triangles.At(tick), Right, triangles.At(tick));
    words += Text(Left - 8.0, triangles.At(tick) + 4.0, "end", GroupedText(tick));
  }
  return svg + "</g>\n" + words;
}

std::string Curve(const std::vector<CurvePoint>& points, const Axis& errors, const Axis& triangles)
{
  std::string path;
  std::string marks;
  for (const CurvePoint& point : points)
  {
    const std::string x = Number(errors.At(point.Error));
    const std::string y = Number(triangles.At(point.Triangles));
    path.append(path.empty() ? "M" : " L").append(x).append(",").append(y);
    marks.append("<circle cx=\"").append(x).append("\" cy=\"").append(y);
    marks.append("\" r=\"4\" fill=\"#1f5fa8\"/>\n");
    marks += Text(errors.At(point.Error) + 8.0, triangles.At(point.Triangles) - 6.0, "start",
      GroupedText(point.Triangles));
  }
  return "<path d=\"" + path + "\" fill=\"none\" stroke=\"#1f5fa8\" stroke-width=\"2\"/>\n" + marks;
}
}

std::string ComposeCurve(const std::string& title, std::vector<CurvePoint> points)
{
  points.erase(std::remove_if(points.begin(), points.end(),
                 [](const CurvePoint& p)
                 { return !(p.Error > 0.0) || !std::isfinite(p.Error) || !(p.Triangles > 0.0); }),
    points.end());
  std::sort(points.begin(), points.end(),
    [](const CurvePoint& a, const CurvePoint& b) { return a.Error < b.Error; });
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + Number(Width) +
    " " + Number(Height) + "\" font-family=\"sans-serif\" font-size=\"13\">\n" +
    "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
    Text(Left, Top - 16.0, "start", title + ": triangles against the proved error");
  if (!points.empty())
  {
    const auto [fewest, most] = std::minmax_element(points.begin(), points.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.Triangles < b.Triangles; });
    const Axis errors = AxisOf(points.front().Error, points.back().Error, Left, Right);
    const Axis triangles = AxisOf(fewest->Triangles, most->Triangles, Bottom, Top);
    svg += Grid(errors, triangles) + Curve(points, errors, triangles);
  }
  return svg +
    Text(0.5 * (Left + Right), Bottom + 48.0, "middle",
      "proved largest distance, both directions, mm") +
    "</svg>\n";
}
}
