// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ProgressDisplay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace bonedecimate
{
namespace
{
constexpr int BarLength = 40;
constexpr int PercentOfALine = 10;
}

std::string TimeLeftText(double seconds, double fraction)
{
  constexpr double leastSeconds = 2.0;
  constexpr double leastFraction = 0.02;
  if (seconds < leastSeconds || fraction < leastFraction)
  {
    return std::string();
  }
  const auto left = static_cast<long>(std::lround(seconds * (1.0 - fraction) / fraction));
  constexpr long minute = 60;
  constexpr long hour = 3600;
  const std::string text = left < minute ? std::to_string(left) + " s"
    : left < hour
    ? std::to_string(left / minute) + " min " + std::to_string(left % minute) + " s"
    : std::to_string(left / hour) + " h " + std::to_string(left % hour / minute) + " min";
  return text + " left";
}

bool ProgressDisplay::IsBar(Progress progress)
{
  return (progress == Progress::Bar || progress == Progress::Lines) && isatty(STDERR_FILENO) == 1;
}

ProgressDisplay::ProgressDisplay(Progress progress)
  : Shown(progress == Progress::Hidden ? Form::Hidden
        : progress == Progress::Tags   ? Form::Tags
        : IsBar(progress)              ? Form::Bar
        : progress == Progress::Lines  ? Form::Lines
                                       : Form::Hidden)
{
}

void ProgressDisplay::Begin(const std::string& phase)
{
  this->Clear();
  this->Phase = phase;
  this->SincePhase = StageClock();
  if (this->Shown != Form::Tags)
  {
    this->Show(0.0);
  }
}

void ProgressDisplay::Show(double fraction, const std::string& detail)
{
  const int percent = std::clamp(static_cast<int>(fraction * 100.0), 0, 100);
  const int step = this->Shown == Form::Lines ? PercentOfALine : 1;
  const bool isSame = this->Percent >= 0 && percent / step == this->Percent / step &&
    (this->Shown != Form::Bar || detail == this->Detail);
  if (this->Shown == Form::Hidden || isSame)
  {
    return;
  }
  this->Percent = percent;
  this->Detail = detail;
  std::string left = TimeLeftText(this->SincePhase.Seconds(), fraction);
  left += (left.empty() || detail.empty() ? "" : ", ") + detail;
  const auto done = static_cast<std::size_t>(percent * BarLength / 100);
  switch (this->Shown)
  {
    case Form::Tags:
      std::printf("<filter-progress>%.2f</filter-progress>\n", percent / 100.0);
      std::fflush(stdout);
      break;
    case Form::Bar:
      std::fprintf(stderr, "\r%s [%s%s] %3d %% %s\033[K", this->Phase.c_str(),
        std::string(done, '#').c_str(), std::string(BarLength - done, ' ').c_str(), percent,
        left.c_str());
      std::fflush(stderr);
      break;
    default:
      std::fprintf(stderr, "%s: %d %%%s%s\n", this->Phase.c_str(), percent,
        left.empty() ? "" : ", ", left.c_str());
  }
}

void ProgressDisplay::Clear()
{
  if (this->Shown == Form::Bar && this->Percent >= 0)
  {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
  }
  this->Percent = -1;
}
}
