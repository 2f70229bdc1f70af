// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Dicom/DicomReaders.h"
#include "DicomFolder.h"

#ifdef BONEDECIMATE_LOADS_ON_DEMAND
#include "LoadOnDemand.h"
#endif

namespace bonedecimate::volume
{
namespace
{
/// Null if the library cannot be loaded.
const DicomReaders* FindDicomReaders([[maybe_unused]] std::string& problem)
{
#ifdef BONEDECIMATE_LOADS_ON_DEMAND
  return static_cast<const DicomReaders*>(
    LoadOnDemand("libBoneDecimateDicom.so", "BoneDecimateDicomReaders", problem));
#else
  return &BoneDecimateDicomReaders;
#endif
}

LayeredVolume NotLoaded(const std::string& problem)
{
  return RejectedLayers("the library that reads DICOM cannot be loaded: " + problem);
}
}

LayeredVolume OpenDicomFolder(const std::string& folder, const SegmentSelection& selection)
{
  std::string problem;
  const DicomReaders* const readers = FindDicomReaders(problem);
  return readers ? readers->OpenFolder(folder, selection, RequestedSeries()) : NotLoaded(problem);
}

LayeredVolume OpenDicomFile(const std::string& file, const SegmentSelection& selection)
{
  std::string problem;
  const DicomReaders* const readers = FindDicomReaders(problem);
  return readers ? readers->OpenFile(file, selection) : NotLoaded(problem);
}
}
