// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

namespace bonedecimate
{
std::string WritePicture(const PictureSubject&, const std::string&)
{
  return "this program was built without rendering (BONEDECIMATE_PICTURES)";
}
}
