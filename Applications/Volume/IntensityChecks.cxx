// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IntensityChecks.h"

#include "Base/Text.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

namespace bonedecimate::volume
{
namespace
{
std::string NumberText(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

std::string RangeProblem(const ValueSurvey& survey, double hounsfield)
{
  const std::string text = " of its voxels is above " + NumberText(hounsfield) +
    " HU: the values go from " + NumberText(survey.GetLeast()) + " to " +
    NumberText(survey.GetLargest());
  if (survey.GetLargest() < hounsfield)
  {
    return "none" + text;
  }
  return survey.GetLeast() >= hounsfield ? "every one" + text : std::string();
}
}

std::string IntensityProblem(const ValueSurvey& survey, double hounsfield, LabelPolicy policy)
{
  if (survey.GetNumberOfNotFinite() > 0)
  {
    return std::to_string(survey.GetNumberOfNotFinite()) + " of its voxels are not finite numbers";
  }
  if (policy == LabelPolicy::Reject && survey.GetKind() == ValueKind::Labels)
  {
    return "it is a label map with the labels " + ListText(survey.GetLabels()) +
      ", whose numbers are names and no intensities: one surface at a value would fuse the parts "
      "and shift their surfaces; give --segments all for a surface of each label, or --intensities "
      "on if these are measured values";
  }
  return RangeProblem(survey, hounsfield);
}

std::string MaskNote(const ValueSurvey& survey)
{
  return survey.GetKind() == ValueKind::Mask
    ? "its values are 0 and " + std::to_string(survey.GetLabels().front()) +
      " alone: a mask, whose surface has steps as large as its voxels"
    : std::string();
}

void AppendNote(std::string& notes, const std::string& note)
{
  notes += (notes.empty() || note.empty() ? "" : "; ") + note;
}

double LeastSide(const VolumeGeometry& geometry, const LayerPositions& layers)
{
  const auto& steps = geometry.Steps;
  return std::min({ Length(steps[0]), Length(steps[1]), LeastDistance(layers) * Length(steps[2]) });
}
}
