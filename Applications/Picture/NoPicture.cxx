// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

namespace bonedecimate
{
std::string WhyNoPictures()
{
  return "this program draws no pictures; that of the Debian package, or built from source, does";
}

std::string WritePicture(const PictureSubject&, const std::string&)
{
  return WhyNoPictures();
}
}
