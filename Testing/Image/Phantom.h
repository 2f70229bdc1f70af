// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Phantom.h
 * @brief The decimated bone of the phantom and its two pictures, for the image tests and their
 * baselines.
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

/// The input of ComposePicture for a run.
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
