// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentFiles.h
 * @brief The surfaces of the segments of a result, and their files.
 */
#ifndef BoneDecimate_Applications_SegmentFiles_h
#define BoneDecimate_Applications_SegmentFiles_h

#include "Arguments/Arguments.h"
#include "Files/OutputFiles.h"
#include "Report/JsonReport.h"

#include "vtkPolyData.h"

namespace bonedecimate
{
/**
 * Notes what is in each segment, and writes the files of the segments and the .vtm file if the
 * output has them. Of a proved result these files come back with the same coordinates bit for bit.
 * @throws Failure(ExitCode::CouldNotWrite)
 */
void WriteSegments(
  vtkPolyData* result, const Arguments& arguments, OutputFiles& files, ReportSubject& subject);
}

#endif
