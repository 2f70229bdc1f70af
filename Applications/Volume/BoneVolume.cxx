// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "BoneVolume.h"

#include "FieldOfView.h"
#include "IntensityChecks.h"
#include "LabelMaps/LabelVolume.h"
#include "OutwardContour.h"
#include "Readers/DataFile.h"
#include "VolumeFile.h"

#include "vtkFieldData.h"
#include "vtkNew.h"

#include <cmath>

namespace bonedecimate
{
using namespace volume;

BoneSurface ExtractBoneSurface(const std::string& path, double hounsfield, LabelPolicy policy,
  const VoxelSpacing& spacing, const VoxelChange& change)
{
  BoneSurface bone;
  if (!std::isfinite(hounsfield))
  {
    bone.Problem = "the Hounsfield value is not a finite number";
    return bone;
  }
  const Volume volume = ReadVolume(path, spacing);
  bone.Note = volume.Note;
  bone.Remark = volume.Remark;
  bone.Problem = volume.Problem;
  if (bone.Problem.empty())
  {
    FieldOfView view(hounsfield);
    view.Add(volume);
    ValueSurvey survey;
    survey.Add(volume);
    bone.Problem = FirstOf({ view.Problem(), IntensityProblem(survey, hounsfield, policy) });
    AppendNote(bone.Note, MaskNote(survey));
    if (view.HasPadding())
    {
      view.Clear(volume);
      bone.Padding = view.Count();
      AppendNote(bone.Note, view.Note());
    }
  }
  if (bone.Problem.empty())
  {
    volume.Image->GetFieldData()->Initialize(); // names of labels are none of the surface's
    if (change)
    {
      const vtkNew<vtkImageData> grid;
      grid->SetDimensions(volume.Image->GetDimensions());
      SetLabelGrid(volume.Geometry, volume.Layers, grid);
      change(volume.Image, grid);
    }
    bone.Surface = OutwardContour(volume, hounsfield);
    // the image's own spacing means nothing
    bone.VoxelSize = LeastSide(volume.Geometry, volume.Layers);
  }
  return bone;
}
}
