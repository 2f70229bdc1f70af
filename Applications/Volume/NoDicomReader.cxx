// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFolder.h"

namespace bonedecimate::volume
{
Volume ReadDicomFolder(const std::string&)
{
  return RejectedVolume(
    "this build reads no DICOM; install GDCM (Debian: libgdcm-dev), configure and "
    "build again");
}
}
