// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Overlay.h
 * @brief Words and lines over the views, placed in fractions of the window.
 */
#ifndef BoneDecimate_Applications_Overlay_h
#define BoneDecimate_Applications_Overlay_h

#include "DistanceColors.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

namespace bonedecimate
{
/// x from the left, y from below, 0 to 1.
using Position = std::array<double, 2>;

enum class Align
{
  Left,
  Center,
  Right
};

struct Words
{
  std::string Text;
  Position At;        ///< Where the text is, at half its height.
  double Size = 0.02; ///< Size of the letters, in heights of the window.
  Align Side = Align::Left;
  bool IsBold = false;
  bool IsQuiet = false; ///< Gray.
  bool IsMark = false;  ///< Blue on white.
};

class Overlay
{
public:
  explicit Overlay(vtkRenderWindow* window);

  void Write(const Words& words);
  /// @param width In heights of the window.
  void Draw(const std::vector<Position>& line, double width = 0.002);
  void DrawRectangle(const Position& lowerLeft, const Position& upperRight, double width = 0.002);
  /// A ring, and words beside it.
  void DrawRing(const Position& middle, const std::string& words);
  /// A bar of the colors of a scale with its title above and numbers below.
  void DrawColorBar(const Position& lowerLeft, const Position& upperRight, const ColorScale& scale,
    const std::string& title);

private:
  void Draw(const std::vector<Position>& line, double width, const Color& color);
  int Pixels(double heights) const;

  vtkRenderWindow* Window;
  vtkSmartPointer<vtkRenderer> Renderer;
};
}

#endif
