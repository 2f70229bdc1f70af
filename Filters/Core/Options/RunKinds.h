// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunKinds.h
 * @brief What does not go together: a row for each kind of run says which needs of options and
 * inputs it lacks.
 *
 * A run offers every need (Needs.h) but those that its row lacks. A run may be of several kinds at
 * once, such as one on several processes whose points have two precisions. A requested option or
 * input that needs what is not offered is rejected with the sentence of the row. Sentences have the
 * names of properties; each adapter replaces them by its own words (flags, keywords).
 */
#ifndef BoneDecimate_Core_Options_RunKinds_h
#define BoneDecimate_Core_Options_RunKinds_h

#include "Needs.h"

#include <string>
#include <string_view>
#include <vector>

namespace bonedecimate
{
struct OptionInfo;

/// Needs that a run does not offer, and why.
struct Lack
{
  NeedList Needs;
  /// In it "{}" is replaced by the name of the request, "{all}" by the names of all requests that
  /// have one of these needs.
  std::string Sentence;
};

struct RunKind
{
  std::string Name;
  std::vector<Lack> Lacks; ///< The first that applies gives the message.
};

/// Rows of the kinds of run. Those of the program are in
/// Applications/CommandLine/Arguments/ArgumentKinds.cxx.
const std::vector<RunKind>& RunKindTable();

/// The row of that name, which there must be.
const RunKind& FindRunKind(std::string_view name);

/// An option or an input, what it needs, and whether it is used.
struct Request
{
  std::string Name;
  NeedList Needs;
  bool IsUsed = true;
};

/// All options of the table.
std::vector<Request> RequestsOf(const Options& options);

/// Why the first of the requests cannot be followed, a sentence without a period; empty if there is
/// none.
std::string FindUnsupported(
  const std::vector<RunKind>& kinds, const std::vector<Request>& requests);

/// Why a kind of run does not have an option; empty if it has it.
std::string WhyUnsupported(const RunKind& kind, const OptionInfo& info);
}

#endif
