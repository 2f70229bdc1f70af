// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Sheets.h
 * @brief Splits a surface along its seams into sheets that are manifold, and joins them again.
 *
 *     a seam:    an edge of three or more triangles or of inconsistent orientation
 *     each corner of a seam, and each point where fans meet:
 *         every fan of triangles round it gets a copy of the point; all copies stand at one site and are pinned
 *
 * Copies never move and never vanish, so that to join is to take the site for each copy. That no two sheets come to share
 * an edge in another way is looked after by Collapse/SheetRules.h.
 *
 * A. Gueziec, G. Taubin, F. Lazarus, B. Horn, Cutting and stitching: converting sets of polygons to manifold surfaces, 2001.
 */
#ifndef BoneDecimate_Core_Mesh_Sheets_h
#define BoneDecimate_Core_Mesh_Sheets_h

#include "Cleaning.h"
#include "HalfEdgeMesh.h"

namespace bonedecimate
{
/// The copies come last; maps go along, each input point stays with its first copy.
/// @param mesh Made of the surface.
/// @return whether anything was split, that is locked: then the mesh has to be made anew, with clean.Sheets.
bool SplitSheets(CleanSurface& clean, const HalfEdgeMesh& mesh);

/// Points, with the copies of one as one.
std::int64_t NumberOfSites(const CleanSurface& clean);

/// Calls use(surface) with the sheets joined.
template <typename Use>
auto WithJoined(const CleanSurface& clean, const Use& use)
{
  const std::vector<Index>& sites = clean.Sheets.Sites;
  if (sites.empty())
  {
    return use(clean.Surface);
  }
  Surface joined = clean.Surface;
  for (Triangle& c : joined.Triangles)
  {
    c = { sites[c[0]], sites[c[1]], sites[c[2]] };
  }
  return use(static_cast<const Surface&>(joined));
}
}

#endif
