// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SegmentOutput.h
 * @brief Where the surfaces of segments go.
 *
 *     --segments all bones.ply     one surface with all segments
 *     --segments all bones.vtm     bones.vtm, and in the folder bones a file for each segment
 *     --segments all bones         in the folder bones a file for each segment, report.json,
 *                                  index.html and picture.png
 */
#ifndef BoneDecimate_Applications_SegmentOutput_h
#define BoneDecimate_Applications_SegmentOutput_h

#include "Arguments/Arguments.h"
#include "Formats/SurfaceFormat.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Whether the output is a .vtm file with a block for each segment.
bool IsBlockFile(const std::string& output);

/// Whether the output of one label map is a folder with a file for each segment.
bool IsSegmentFolder(const Arguments& arguments);

/// Whether each segment has a file of its own.
bool WritesSegments(const Arguments& arguments);

/// The folder of the files of segments.
std::string FolderOfSegments(const Arguments& arguments);

/// The extension of the files of segments.
std::string ExtensionOfSegments(const Arguments& arguments);

/// Formats of all surfaces that one run writes, except heat maps.
std::vector<const SurfaceFormat*> FormatsOfSurfaces(const Arguments& arguments);

/// Report, page and picture of a folder of segments get their names there if they have none, unless
/// there are many bones.
void NameFilesOfFolder(Arguments& arguments);
}

#endif
