// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PictureWriter.h
 * @brief The entry of the library that renders.
 */
#ifndef BoneDecimate_Applications_PictureWriter_h
#define BoneDecimate_Applications_PictureWriter_h

#include "Picture.h"

#include <string>

namespace bonedecimate
{
/// What Picture.h declares.
struct PictureWriter
{
  std::string (*Write)(const PictureSubject& subject, const std::string& file);
};
}

extern "C" const bonedecimate::PictureWriter BoneDecimatePictureWriter;

#endif
