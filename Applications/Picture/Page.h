// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Page.h
 * @brief One self-contained HTML page about one decimated bone, or about its levels of detail.
 */
#ifndef BoneDecimate_Applications_Page_h
#define BoneDecimate_Applications_Page_h

#include "PairView.h"
#include "Picture.h"
#include "SurfaceExtents.h"

#include "vtkPolyData.h"

#include <string>
#include <vector>

namespace bonedecimate
{
/// Result is output port 0 of vtkBoneDecimate, with arrays and report in its field data, Before the
/// input of the run without what was pruned.
struct PageSubject : PairSubject
{
  std::string Name;    ///< What the page calls the bone (a file name, never patient data).
  std::string Command; ///< What makes the same again, without folders; empty: not known.
  /// What changed in the voxels before extraction; empty: nothing was requested.
  std::vector<std::string> Changes;
  std::string PictureFile; ///< A PNG to embed; empty: no picture, and the page says so.
  SpeckFigures Specks;     ///< FindSpecks() of Before.
  std::string ModelGrid;   ///< A sentence on the grid that labels were extracted on; may be empty.
};

/// A level of detail of a recorded run.
struct PageLevel
{
  vtkSmartPointer<vtkPolyData> Surface;
  double MaxDistance = 0.0;  ///< mm, measured; not a number if it was not.
  double MeanDistance = 0.0; ///< mm
};

struct LevelsPageSubject
{
  std::string Name; ///< What the page calls the bone.
  vtkPolyData* Before = nullptr;
  std::vector<PageLevel> Levels; ///< At least one, from coarse to fine.
  std::string Report;            ///< JSON, of the run; of none if the levels come from a log.
  std::string DistanceArrayName; ///< On each level, mm; empty: none.
  std::string PictureFile;       ///< A PNG to embed; empty: no picture, and the page says so.
  SurfaceReducer Reduce;
  std::string Frame; ///< As that of PageSubject.
};

/// The page as HTML text, with the interactive view if the program was built with it: 20 MB at
/// most, if surfaces can be reduced.
std::string ComposePage(const PageSubject& subject);

/// The page of the levels of one run, with all of them in the interactive view.
std::string ComposeLevelsPage(const LevelsPageSubject& subject);

/// What captions say of a run, from the report that its result, After, carries.
void TakeReport(PictureSubject& subject);
}

#endif
