// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceFormat.h
 * @brief The surface formats and what each of them can hold.
 */
#ifndef BoneDecimate_Applications_SurfaceFormat_h
#define BoneDecimate_Applications_SurfaceFormat_h

#include <string>

namespace bonedecimate
{
enum class SurfaceFormat
{
  Unknown,
  Obj,
  Stl,
  Ply,
  Vtp,
  Vtk
};

/// "obj stl ply vtp vtk", for messages.
extern const char* const SurfaceExtensions;

/// A to Z as a to z; letters beyond ASCII stay as they are.
std::string LowerText(std::string text);

/// The extension in small letters, without its dot; of "a.b/NAME.STL" it is "stl".
std::string ExtensionOf(const std::string& path);

/// By the extension, whatever its case.
SurfaceFormat FormatOf(const std::string& path);

/// Whether it keeps arrays (distances, report) beside points and triangles.
bool HoldsArrays(SurfaceFormat format);

/// Whether coordinates in double precision come back from it as they were.
bool HoldsDoubles(SurfaceFormat format);

/// The last part of a path: reports name files without their folders.
std::string BaseName(const std::string& path);
}

#endif
