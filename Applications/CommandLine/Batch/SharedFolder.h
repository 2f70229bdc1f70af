// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharedFolder.h
 * @brief Several batches with the same output folder, on one machine or on many: each input is at
 * work in one of them.
 *
 * While batches run, the output folder has a hidden folder .bonedecimate with
 *
 *     NAME.claim     a folder: the input is at work; NAME may have folders
 *     NAME.failed    exit code and message of an input that failed
 *     NUMBER.batch   a folder: a batch is at work; the last that ends removes all of this
 *
 * A batch renews the times of its folders. One that is older than a minute belongs to a batch that
 * was killed, and does not count. All times are those of the file system, which is the same for
 * all machines.
 */
#ifndef BoneDecimate_Applications_SharedFolder_h
#define BoneDecimate_Applications_SharedFolder_h

#include "ExitCode.h"

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace bonedecimate
{
class SharedFolder
{
public:
  /// @param output The output folder, which is there.
  /// @param options Those of the batch, as on a command line.
  /// @throws Failure(ExitCode::CouldNotWrite), and Failure(ExitCode::Usage) if a batch with other
  /// options is at work in the folder.
  SharedFolder(const std::string& output, const std::string& options);
  ~SharedFolder();
  SharedFolder(const SharedFolder&) = delete;
  void operator=(const SharedFolder&) = delete;

  /// Whether another batch is at work in the folder.
  bool HasOthers() const;

  /// Whether the input is now at work in this batch; false: it is in another one.
  bool Claim(const std::string& name);
  void Release(const std::string& name);

  /// Renews what is of this batch. To be called again and again: most calls do nothing.
  void Renew();

  struct InputFailure
  {
    ExitCode Code;
    std::string Message;
  };

  void NoteFailure(const std::string& name, const InputFailure& failure) const;

  /// The problem of an input that failed in another batch since this one began.
  std::optional<InputFailure> FailureOf(const std::string& name) const;

  /// Whether a file was written since this batch began.
  bool IsNew(const std::string& file) const;

private:
  using Path = std::filesystem::path;
  using Time = std::filesystem::file_time_type;

  Path PathOf(const std::string& name, const char* extension) const;
  bool IsAlive(const Path& folder) const;
  bool RemoveDead(const Path& folder) const;
  std::vector<Path> OtherBatches() const;

  Path Hidden;
  Path Own;
  Time Begin;
  std::set<Path> Claims;
  std::chrono::steady_clock::time_point Renewed;
};
}

#endif
