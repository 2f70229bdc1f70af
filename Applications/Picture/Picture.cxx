// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Rendering/PictureWriter.h"

#ifdef BONEDECIMATE_LOADS_ON_DEMAND
#include "LoadOnDemand.h"
#endif

namespace bonedecimate
{
std::string WhyNoPictures()
{
  return {};
}

//------------------------------------------------------------------------------
std::string WritePicture(const PictureSubject& subject, const std::string& file)
{
#ifdef BONEDECIMATE_LOADS_ON_DEMAND
  std::string problem;
  const auto* const writer = static_cast<const PictureWriter*>(
    LoadOnDemand("libBoneDecimateRendering.so", "BoneDecimatePictureWriter", problem));
  return writer ? writer->Write(subject, file)
                : "the library that draws pictures cannot be loaded: " + problem;
#else
  return BoneDecimatePictureWriter.Write(subject, file);
#endif
}
}
