// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"

#include "OutwardContour.h"
#include "VolumeFile.h"
#include "VoxelValues.h"

#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace bonedecimate
{
using namespace volume;

namespace
{
std::string NumberText(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

/// "1, 2, 3 and 17 more"
std::string ListText(const std::vector<int>& labels)
{
  constexpr std::size_t most = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(labels.size(), most); ++i)
  {
    text += (i > 0 ? ", " : "") + std::to_string(labels[i]);
  }
  return labels.size() > most ? text + " and " + std::to_string(labels.size() - most) + " more"
                              : text;
}

/// Of a label map the reason why it has no one surface; of a mask a note.
void CheckLabels(const Volume& volume, LabelPolicy policy, BoneSurface& bone)
{
  const ValueSurvey survey = SurveyValues(volume);
  if (survey.Kind == ValueKind::Mask)
  {
    bone.Note += (bone.Note.empty() ? "" : "; ") + std::string("its values are 0 and ") +
      std::to_string(survey.Labels[0]) +
      " alone: a mask, whose surface has steps as large as its voxels";
  }
  if (survey.Kind == ValueKind::Labels && policy == LabelPolicy::Reject)
  {
    bone.Problem = "it is a label map with the labels " + ListText(survey.Labels) +
      ", whose numbers are names and no intensities: one surface at a value would fuse the parts "
      "and shift their surfaces; give --segments all for a surface of each label, or --intensities "
      "on if these are measured values";
  }
}

/// Why the voxels have no surface at that value, or an empty text.
std::string ValuesProblem(vtkImageData* image, double hounsfield)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const vtkIdType strange = CountNotFinite(values);
  if (strange > 0)
  {
    return std::to_string(strange) + " of its voxels are not finite numbers";
  }
  double range[2];
  values->GetRange(range);
  const std::string text = " of its voxels is above " + NumberText(hounsfield) +
    " HU: the values go from " + NumberText(range[0]) + " to " + NumberText(range[1]);
  if (range[1] < hounsfield)
  {
    return "none" + text;
  }
  return range[0] >= hounsfield ? "every one" + text : std::string();
}
}

BoneSurface ExtractBoneSurface(
  const std::string& path, double hounsfield, LabelPolicy policy, const VoxelSpacing& spacing)
{
  BoneSurface bone;
  if (!std::isfinite(hounsfield))
  {
    bone.Problem = "the Hounsfield value is not a finite number";
    return bone;
  }
  const Volume volume = ReadVolume(path, spacing);
  bone.Note = volume.Note;
  bone.Problem = volume.Problem.empty() ? ValuesProblem(volume.Image, hounsfield) : volume.Problem;
  if (bone.Problem.empty())
  {
    CheckLabels(volume, policy, bone);
  }
  if (bone.Problem.empty())
  {
    volume.Image->GetFieldData()->Initialize(); // names of labels are none of the surface's
    bone.Surface = OutwardContour(volume, hounsfield);
    const auto& steps = volume.Geometry.Steps; // the image's own spacing means nothing
    bone.VoxelSize = std::min({ Length(steps[0]), Length(steps[1]), Length(steps[2]) });
  }
  return bone;
}
}
