// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Goal.h
 * @brief What a loop runs towards, how far it has come, and whom it tells.
 */
#ifndef BoneDecimate_Core_Collapse_Goal_h
#define BoneDecimate_Core_Collapse_Goal_h

#include "Editor.h"
#include "Monitor.h"

namespace bonedecimate
{
struct Stops
{
  Index Faces = 0; ///< A number of triangles to come down to.
  /// mm, mode Thesis alone: a distance of a new vertex to the original that has to be reached as well; 0: no such wish.
  double Error = 0.0;
};

/// What the options ask for on a surface of that many faces; a default reduction steps back for other wishes. In the
/// modes that prove their largest error that is no stop: the guarantee refuses what is beyond it.
/// @param isLimited Whether every point has a tolerance: such a wish, too.
Stops StopsOf(const Options& options, Index faces, bool isLimited = false);

class Goal
{
public:
  Goal(const Editor& editor, const Stops& stops);

  /// From where the mesh is now, towards something else.
  void Set(const Stops& stops);

  bool IsReached() const;

  /// Why it is reached, while IsReached().
  StopReason Reason() const;

  /// Tells the monitor every half percent, or at once. False if it asked to stop.
  bool Tell(const Monitor& monitor);
  /// @param unsettled Faces that workers have removed and the mesh has not counted yet.
  bool TellNow(const Monitor& monitor, Index unsettled = 0);

private:
  bool ErrorIsReached() const;
  double FractionDone(Index unsettled) const;

  const Editor& Work;
  Stops Wanted;
  Index FacesAtFirst;
  double Told = 0.0;
};
}

#endif
