// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditAlone.h
 * @brief Edits by the only worker, which are settled at once.
 */
#ifndef BoneDecimate_Testing_Unit_EditAlone_h
#define BoneDecimate_Testing_Unit_EditAlone_h

#include "Decimate/Edit/Editor.h"

namespace bonedecimate
{
inline Decision GatherAlone(Editor& editor, HalfEdgeId edge)
{
  EditWorkspace work;
  const Decision decision = editor.Gather(edge, work);
  editor.Settle(&work.Counts);
  return decision;
}

/// Whether a draft was made of what the callable does, and proved.
template <typename Collapse>
bool MakeProvedDraft(Editor& editor, const Collapse& collapse)
{
  bool isCalled = false;
  const auto call = [&]
  {
    isCalled = true;
    collapse();
    return true;
  };
  return editor.MakeDraft(1, call, [](double) { return true; }) && isCalled;
}

inline Decision TryAlone(Editor& editor, const Edit& edit)
{
  EditWorkspace work;
  const Decision decision = editor.Try(edit, work);
  editor.Settle(&work.Counts);
  return decision;
}
}

#endif
