// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FragmentVolumes.h
 * @brief Volume changes of a worker that are not settled yet, by component.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_FragmentVolumes_h
#define BoneDecimate_Core_Proof_EditFilters_FragmentVolumes_h

#include "Geometry/Surface.h"

#include <vector>

namespace bonedecimate
{
/// A list: a worker edits few components.
class FragmentVolumes
{
public:
  struct Change
  {
    Index Component;
    double Volume; // mm^3
  };

  double Of(Index component) const
  {
    for (const Change& change : this->List)
    {
      if (change.Component == component)
      {
        return change.Volume;
      }
    }
    return 0.0;
  }

  void Add(Index component, double volume)
  {
    for (Change& known : this->List)
    {
      if (known.Component == component)
      {
        known.Volume += volume;
        return;
      }
    }
    this->List.push_back({ component, volume });
  }

  const std::vector<Change>& Changes() const { return this->List; }
  /// Keeps its memory.
  void Clear() { this->List.clear(); }

private:
  std::vector<Change> List;
};
}

#endif
