// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunKinds.h
 * @brief What does not go together: a row for each kind of run says which needs of options and inputs it lacks.
 *
 * A run offers every need (Needs.h) but those that its row lacks. A run may be of several kinds at once, such as one on several
 * processes whose points have two precisions. What is asked for and not offered is rejected with the sentence of the row, where
 * its words are the names of properties; each adapter puts its own in their place (flags, keywords).
 */
#ifndef BoneDecimate_Core_Options_RunKinds_h
#define BoneDecimate_Core_Options_RunKinds_h

#include "Needs.h"

#include <string>
#include <vector>

namespace bonedecimate
{
struct OptionInfo;

/// Needs that a run does not offer, and why.
struct Lack
{
  NeedList Needs;
  /// "{}" stands for what was asked for, "{all}" for all that has one of these needs.
  std::string Sentence;
};

struct RunKind
{
  std::string Name;
  std::vector<Lack> Lacks; ///< The first that applies is told.
};

/// Rows of the kinds of run. Those of the program are in Applications/CommandLine/ArgumentKinds.cxx.
const std::vector<RunKind>& RunKindTable();

/// The row of that name, which there must be.
const RunKind& FindRunKind(const std::string& name);

/// An option or an input, what it needs, and whether it is asked for.
struct Request
{
  std::string Name;
  NeedList Needs;
  bool IsUsed = true;
};

/// All options of the table.
std::vector<Request> RequestsOf(const Options& options);

/// Why the first of the requests cannot be followed, a sentence without a period; empty if there is none.
std::string FindUnsupported(
  const std::vector<RunKind>& kinds, const std::vector<Request>& requests);

/// Why a kind of run does not have an option; empty if it has it.
std::string WhyUnsupported(const RunKind& kind, const OptionInfo& info);
}

#endif
