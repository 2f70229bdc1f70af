// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProgressDisplay.h
 * @brief The phase of a run, how much of it is done and the time left: a bar on a terminal, lines
 * in a file, or 3D Slicer's tags.
 */
#ifndef BoneDecimate_Applications_ProgressDisplay_h
#define BoneDecimate_Applications_ProgressDisplay_h

#include "Base/StageClock.h"

#include <string>

namespace bonedecimate
{
enum class Progress
{
  Hidden,
  Bar,   ///< A bar on the error output, if that is a terminal.
  Lines, ///< A bar on a terminal; otherwise a line on the error output every 10 %.
  Tags   ///< Tags of 3D Slicer, on the standard output; without the phase.
};

class ProgressDisplay
{
public:
  explicit ProgressDisplay(Progress progress);
  ~ProgressDisplay() { this->Clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  /// @param phase "reading".
  void Begin(const std::string& phase);

  /// @param fraction Fraction of the phase that is done, 0 to 1.
  /// @param detail Text of a bar or a line behind it.
  void Show(double fraction, const std::string& detail = {});

  /// Whether a bar is drawn.
  static bool IsBar(Progress progress);

  /// Removes the bar.
  void Clear();

private:
  enum class Form
  {
    Hidden,
    Bar,
    Lines,
    Tags
  };

  Form Shown;
  std::string Phase;
  StageClock SincePhase;
  int Percent = -1;
  std::string Detail;
};

/// "2 min 5 s left", from the seconds that a fraction took; empty while that says too little.
std::string TimeLeftText(double seconds, double fraction);
}

#endif
