// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ComposedPicture.h
 * @brief The three views of a picture, its captions and its color bar in one window.
 */
#ifndef BoneDecimate_Applications_ComposedPicture_h
#define BoneDecimate_Applications_ComposedPicture_h

#include "Picture.h"

#include "vtkRenderWindow.h"

namespace bonedecimate
{
/// Puts the three views into a window; the caller renders it. The window's size decides the layout.
void ComposePicture(vtkRenderWindow* window, const PictureSubject& subject);
}

#endif
