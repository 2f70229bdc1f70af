// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Phantom.h
 * @brief The phantom's bone, decimated, and its two pictures: what the image tests and their
 * baselines are made of.
 */
#ifndef BoneDecimate_Testing_Phantom_h
#define BoneDecimate_Testing_Phantom_h

#include "Picture.h"

#include "vtkBoneDecimate.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace bonedecimate
{
/// The filter after its run over the bone of a CT volume at 226 HU; null if the volume cannot be
/// used.
vtkSmartPointer<vtkBoneDecimate> DecimatePhantom(const std::string& volume);

/// What ComposePicture shows of a run.
PictureSubject SubjectOf(vtkBoneDecimate* filter);

struct PhantomPictures
{
  vtkSmartPointer<vtkImageData> BeforeAndAfter;
  vtkSmartPointer<vtkImageData> Distance;
};

/// The picture at a fixed size, cut at the third column. Needs a display.
PhantomPictures RenderPhantom(const PictureSubject& subject);
}

#endif
