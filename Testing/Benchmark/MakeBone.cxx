// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MakeBone.cxx
 * @brief Writes one of the benchmark's bones as binary PLY.
 *
 *     bonedecimate-bone whole|maxilla|frontal|vault VOLUME.mhd OUTPUT.ply
 *     bonedecimate-bone file SURFACE OUTPUT.ply
 *     bonedecimate-bone specimen TRIANGLES OUTPUT.ply
 */
#include "Bones.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

namespace
{
Triangles Make(const std::string& kind, const std::string& from)
{
  if (kind == "whole")
  {
    return WholeBone(from);
  }
  if (kind == "maxilla" || kind == "frontal")
  {
    return LargestIn(from, kind == "maxilla" ? Maxilla : FrontalBone);
  }
  if (kind == "vault")
  {
    return BinaryCrop(from, Vault);
  }
  if (kind == "file")
  {
    return SurfaceFile(from);
  }
  if (kind == "specimen" && std::atof(from.c_str()) >= 1000.0)
  {
    return GrownSpecimen(std::atof(from.c_str()));
  }
  throw std::runtime_error("unknown bone " + kind + " " + from);
}
}

int main(int argumentCount, char** words)
{
  if (argumentCount != 4)
  {
    std::fputs(
      "usage: bonedecimate-bone whole|maxilla|frontal|vault|file|specimen FROM OUTPUT.ply\n",
      stderr);
    return EXIT_FAILURE;
  }
  try
  {
    const Triangles bone = Make(words[1], words[2]);
    WritePly(words[3], bone, Coordinates::Single);
    std::printf("{\"triangles\": %zu, \"points\": %zu}\n", bone.Corners.size(), bone.Points.size());
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "bonedecimate-bone: %s\n", failure.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
