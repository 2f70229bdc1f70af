// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batch.h"

#include "BatchJob.h"
#include "BatchOptions.h"
#include "BatchOutput.h"
#include "BatchPlan.h"
#include "BatchTable.h"
#include "BoneVolume.h"
#include "EarlierResults.h"
#include "FailureLog.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Files/StagedFile.h"
#include "Files/StagedFolder.h"
#include "FolderTable.h"
#include "NumberText.h"
#include "Segments/SegmentChoice.h"
#include "SharedFolder.h"
#include "Terminal/Interruption.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <filesystem>
#include <list>
#include <optional>
#include <thread>
#include <vector>

namespace bonedecimate
{
namespace
{
/// What a process that died left of a folder of segments, if the output is one.
void RemoveSegmentFolder(int process, const std::string& output)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(FilePath(output), ignored))
  {
    RemoveStagedFilesOf(process, output);
    std::filesystem::remove(FilePath(output), ignored); // only if it is empty
  }
}

const char* const OfAnotherShard = "of another shard";

/// The folder that has the output, a file or a folder.
std::string FolderAround(const std::string& output)
{
  const std::filesystem::path path = FilePath(output);
  return (path.has_filename() ? path : path.parent_path()).parent_path().string();
}

class Batch
{
public:
  Batch(const Arguments& arguments, const std::string& self)
    : Requested(arguments)
    , Self(self)
    , Bones(PlanBatch(arguments))
    , Rows(Bones.size())
    , Printed(arguments)
  {
    RejectOtherOptions(this->Bones, arguments);
    this->Table.emplace(arguments.Output, this->Bones);
    for (std::size_t i = 0; i < this->Bones.size(); ++i)
    {
      this->Rows[i].Name = this->Bones[i].Name;
      this->Rows[i].Input = PathBelow(this->Bones[i]);
      this->ToDo.push_back(i);
    }
    this->NameWidth = WidthOfNames(this->Rows);
  }

  ExitCode Run()
  {
    this->MakeFolder(this->Requested.Output);
    this->Shared.emplace(this->Requested.Output, OptionsText(this->Requested));
    this->Table->Write(this->Rows);
    this->Table->Require();
    if (HasDefaultTarget(this->Requested))
    {
      this->Printed.Tell("note: without --max-error and a target nine tenths of the triangles are "
                         "removed, and nothing is proved");
    }
    this->Printed.Tell(BatchHeading(this->NameWidth));
    while (!this->ToDo.empty() || !this->Running.empty())
    {
      this->StartSome();
      this->CollectEnded();
      this->Printed.Show(this->Ended, this->Bones.size());
      this->Shared->Renew();
    }
    this->TakeOtherShards();
    this->Leave();
    this->Table->Write(this->Rows);
    if (this->Table->HasProblem())
    {
      this->Printed.TellFailure(BatchCounts(this->Rows));
    }
    this->Table->Require();
    this->Printed.Tell(BatchCounts(this->Rows) + "; table: " + this->Table->Path());
    StopIfInterrupted();
    return this->WorstCode();
  }

private:
  /// Makes a folder, which is removed again if it ends up empty.
  void MakeFolder(const std::string& path)
  {
    std::error_code error;
    if (!std::filesystem::is_directory(FilePath(path), error))
    {
      this->Folders.emplace_back(path);
    }
  }

  /// Folders that are still empty go, unless another batch may be about to write into them.
  void Leave()
  {
    if (this->Shared->HasOthers())
    {
      for (StagedFolder& folder : this->Folders)
      {
        folder.Keep();
      }
    }
    this->Shared.reset();
    this->Folders.clear();
  }

  void StartSome()
  {
    const auto jobs = static_cast<std::size_t>(std::max(this->Requested.Jobs, 1));
    const auto now = std::chrono::steady_clock::now();
    std::deque<std::size_t> deferred;
    while (!this->ToDo.empty() && this->Running.size() < jobs && !IsInterrupted() &&
      now >= this->NextLook)
    {
      const std::size_t bone = this->ToDo.front();
      this->ToDo.pop_front();
      if (!this->Begin(bone))
      {
        deferred.push_back(bone);
      }
    }
    if (this->ToDo.empty() && !deferred.empty())
    {
      this->NextLook = now + std::chrono::seconds(1); // until another batch has ended one
    }
    this->ToDo.insert(this->ToDo.end(), deferred.begin(), deferred.end());
    if (IsInterrupted())
    {
      this->ToDo.clear();
      for (BatchJob& job : this->Running)
      {
        job.Child.Interrupt();
      }
    }
  }

  /// Begins an input, or ends it if there is nothing to do. False: it is at work in another batch.
  bool Begin(std::size_t index)
  {
    const BatchBone& bone = this->Bones[index];
    if (!bone.IsBone())
    {
      this->End(index, "skipped", bone.CodeIfNot, bone.WhyNot);
    }
    else if (this->IsFinished(bone))
    {
      this->EndFinished(index);
    }
    else if (!this->Requested.Shard.Has(index))
    {
      this->End(index, "not run", ExitCode::Done, OfAnotherShard);
    }
    else if (const auto failure = this->Shared->FailureOf(bone.Name))
    {
      this->End(index, "failed", failure->Code, failure->Message);
    }
    else if (!this->Shared->Claim(bone.Name))
    {
      return false;
    }
    else if (this->IsFinished(bone)) // by another batch, a moment ago
    {
      this->Shared->Release(bone.Name);
      this->EndFinished(index);
    }
    else
    {
      this->Start(index);
    }
    return true;
  }

  /// What other shards made of their inputs in the meantime, or before.
  void TakeOtherShards()
  {
    for (std::size_t i = 0; i < this->Bones.size(); ++i)
    {
      BatchRow& row = this->Rows[i];
      if (row.Message != OfAnotherShard)
      {
        continue;
      }
      const std::optional<BatchRow> failed = ReadFailureLog(this->LogOf(i));
      if (this->IsFinished(this->Bones[i]))
      {
        row.Message.clear();
        row.Status = "done";
        TakeReport(row, this->Bones[i].Report);
      }
      else if (failed)
      {
        row.Status = failed->Status;
        row.Code = failed->Code;
        row.Message = failed->Message;
      }
    }
  }

  void EndFinished(std::size_t index)
  {
    const bool isNew = this->Shared->IsNew(this->Bones[index].Report);
    this->Rows[index].Note = isNew ? "" : "by an earlier run; --force does it again";
    this->End(index, "done", ExitCode::Done, "", true);
  }

  bool IsFinished(const BatchBone& bone) const
  {
    return (!this->Requested.Force || this->Shared->IsNew(bone.Report)) &&
      HasEarlierResult(bone, this->Requested);
  }

  void Start(std::size_t bone)
  {
    // A report that does not fit the output any more would make a later run skip a bone that failed
    // in this one.
    std::error_code ignored;
    std::filesystem::remove(FilePath(this->Bones[bone].Report), ignored);
    std::filesystem::remove(FilePath(this->LogOf(bone)), ignored);
    try
    {
      this->MakeFolder(FolderAround(this->Bones[bone].Output));
      this->Running.emplace_back(bone, this->Self, this->Bones[bone], this->Requested);
    }
    catch (const Failure& failure)
    {
      this->EndFailed(bone, failure.Code, failure.what(), failure.what());
    }
  }

  void CollectEnded()
  {
    const std::size_t before = this->Running.size();
    for (auto job = this->Running.begin(); job != this->Running.end();)
    {
      job->InterruptBeyondLimits();
      if (job->Child.HasEnded())
      {
        this->Note(*job);
        job = this->Running.erase(job);
      }
      else
      {
        ++job;
      }
    }
    if (this->Running.size() < before)
    {
      this->Table->Write(this->Rows);
    }
    else if (!this->Running.empty() || !this->ToDo.empty())
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  void Note(const BatchJob& job)
  {
    if (job.Child.HasDied())
    {
      const BatchBone& bone = this->Bones[job.Bone];
      RemoveStagedFilesOf(job.Child.GetProcess(), FolderAround(bone.Output));
      RemoveSegmentFolder(job.Child.GetProcess(), bone.Output);
    }
    const ExitCode code = job.Child.GetCode();
    for (const char* reason : { NoLabelReason, NoChosenVoxelReason, NoSeriesReason })
    {
      const std::size_t begin = job.Child.GetMessage().find(reason);
      if (code == ExitCode::InputRejected &&
        begin != std::string::npos) // a structure out of view, a scan of another kind
      {
        const std::string message = job.Child.GetMessage().substr(begin);
        return this->EndOwn(job.Bone, "skipped", ExitCode::Done, message);
      }
    }
    if (!job.Excess.empty() && code == ExitCode::Interrupted)
    {
      const std::string excess = job.Excess + ", and was stopped";
      return this->EndFailed(job.Bone, job.CodeOfExcess, excess, excess);
    }
    const std::string message = job.Child.GetMessage();
    if (code != ExitCode::Done && code != ExitCode::Interrupted)
    {
      const std::string printed = job.Child.GetErrors();
      return this->EndFailed(job.Bone, code, printed.empty() ? message : printed, message);
    }
    this->EndOwn(job.Bone, code == ExitCode::Done ? "done" : "interrupted", code, message);
  }

  std::string LogOf(std::size_t bone) const
  {
    return this->Requested.Output + "/" + this->Bones[bone].Name + ".log";
  }

  /// Writes a log of an input that failed, and its row, which says if the log could not be written.
  void EndFailed(std::size_t bone, ExitCode code, const std::string& printed, std::string message)
  {
    try
    {
      WriteFailureLog(this->LogOf(bone), printed, this->Rows[bone].Input, code);
    }
    catch (const Failure& failure)
    {
      message += std::string("; its log: ") + failure.what();
    }
    this->EndOwn(bone, "failed", code, message);
  }

  /// What became of an input that was at work in this batch.
  void EndOwn(
    std::size_t bone, const std::string& status, ExitCode code, const std::string& message)
  {
    if (status == "failed")
    {
      this->Shared->NoteFailure(this->Bones[bone].Name, { code, message });
    }
    this->Shared->Release(this->Bones[bone].Name);
    this->End(bone, status, code, message, status == "done");
  }

  /// What became of a bone, in its row and in a line.
  /// @param hasReport Whether the report in the output folder is that of this input.
  void End(std::size_t bone, const std::string& status, ExitCode code, const std::string& message,
    bool hasReport = false)
  {
    BatchRow& row = this->Rows[bone];
    row.Status = status;
    row.Code = code;
    row.Message = message;
    if (hasReport)
    {
      TakeReport(row, this->Bones[bone].Report);
    }
    ++this->Ended;
    const std::string line = BatchLine(row, this->NameWidth);
    status == "failed" ? this->Printed.TellFailure(line) : this->Printed.Tell(line);
  }

  /// The worst of this shard.
  ExitCode WorstCode() const
  {
    std::vector<BatchRow> own;
    for (std::size_t i = 0; i < this->Rows.size(); ++i)
    {
      if (this->Requested.Shard.Has(i))
      {
        own.push_back(this->Rows[i]);
      }
    }
    return WorstCodeOf(own);
  }

  const Arguments& Requested;
  const std::string& Self;
  std::vector<BatchBone> Bones;
  std::vector<BatchRow> Rows;
  std::optional<FolderTable> Table;
  std::size_t NameWidth = 0;
  std::size_t Ended = 0;
  std::list<StagedFolder> Folders;
  std::optional<SharedFolder> Shared; // while inputs are at work
  std::deque<std::size_t> ToDo;
  std::list<BatchJob> Running;
  std::chrono::steady_clock::time_point NextLook; // at inputs that are at work in other batches
  BatchOutput Printed;
};
}

ExitCode RunBatch(const Arguments& arguments, const std::string& self)
{
  return Batch(arguments, self).Run();
}
}
