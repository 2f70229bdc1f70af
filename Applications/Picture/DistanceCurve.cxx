// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PageParts.h"

#include "DistanceColors.h"
#include "NumberText.h"
#include "SurfaceDistances.h"

#include <algorithm>
#include <array>

namespace bonedecimate
{
namespace
{
// The drawing in its own units; the curve's corner values are 0 mm, 0 % and the range, 100 %.
constexpr double Width = 480.0;
constexpr double Height = 250.0;
constexpr double Left = 48.0;
constexpr double Right = 462.0;
constexpr double Top = 14.0;
constexpr double Bottom = 200.0;
constexpr int Steps = 160;
constexpr std::array<double, 3> Marked = { 0.5, 0.95, 0.99 };

double AcrossOf(double fraction)
{
  return Left + fraction * (Right - Left);
}

double DownOf(double fraction)
{
  return Bottom - fraction * (Bottom - Top);
}

std::string At(double x, double y)
{
  return GroupedText(x, 1) + "," + GroupedText(y, 1);
}

std::string Text(double x, double y, const std::string& anchor, const std::string& text)
{
  return "<text x=\"" + GroupedText(x, 1) + "\" y=\"" + GroupedText(y, 1) + "\" text-anchor=\"" +
    anchor + "\">" + text + "</text>\n";
}

std::string Axes(double range)
{
  std::string svg;
  for (int i = 0; i <= 4; ++i)
  {
    const double fraction = 0.25 * i;
    svg += "<path class=\"grid\" d=\"M" + At(Left, DownOf(fraction)) + " L" +
      At(Right, DownOf(fraction)) + " M" + At(AcrossOf(fraction), Bottom) + " L" +
      At(AcrossOf(fraction), Bottom + 5.0) + "\"/>\n";
    svg += Text(Left - 6.0, DownOf(fraction) + 4.0, "end", GroupedText(100.0 * fraction) + " %");
    svg += Text(AcrossOf(fraction), Bottom + 19.0, "middle", ShortText(fraction * range));
  }
  return svg +
    Text(AcrossOf(0.5), Bottom + 40.0, "middle",
      "distance of the original's points to the result, mm");
}

std::string Curve(const std::vector<double>& sorted, double range)
{
  std::string path;
  for (int i = 0; i <= Steps; ++i)
  {
    const double across = static_cast<double>(i) / Steps;
    const auto within =
      std::upper_bound(sorted.begin(), sorted.end(), across * range) - sorted.begin();
    const double fraction = static_cast<double>(within) / static_cast<double>(sorted.size());
    path += (i == 0 ? "M" : " L") + At(AcrossOf(across), DownOf(fraction));
  }
  return "<path class=\"curve\" d=\"" + path + "\"/>\n";
}

std::string Marks(const std::vector<double>& sorted, double range)
{
  std::string svg;
  for (const double fraction : Marked)
  {
    const double across = AcrossOf(Quantile(sorted, fraction) / range);
    svg += "<circle class=\"mark\" cx=\"" + GroupedText(across, 1) + "\" cy=\"" +
      GroupedText(DownOf(fraction), 1) + "\" r=\"4\"/>\n";
  }
  return svg;
}
}

std::string DistanceCurve(const std::vector<double>& sorted)
{
  const double range = ColorRange(sorted);
  return "<svg viewBox=\"0 0 " + GroupedText(Width) + " " + GroupedText(Height) +
    "\" role=\"img\" aria-label=\"Fraction of the original's points within a distance of the "
    "result\">\n" +
    Axes(range) + Curve(sorted, range) + Marks(sorted, range) + "</svg>\n";
}
}
