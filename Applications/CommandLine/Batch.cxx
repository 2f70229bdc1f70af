// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batch.h"

#include "BatchPlan.h"
#include "BatchTable.h"
#include "BoneVolume.h"
#include "ChildProcess.h"
#include "FileNames.h"
#include "FilePath.h"
#include "Interruption.h"
#include "JsonReport.h"
#include "SegmentChoice.h"
#include "StagedFile.h"
#include "StagedFolder.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <list>
#include <thread>
#include <unistd.h>

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

constexpr std::size_t LongestName = 60; // longer names move the rest of their lines

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
    , Terminal(!arguments.Quiet && isatty(STDOUT_FILENO) == 1)
  {
    for (std::size_t i = 0; i < this->Bones.size(); ++i)
    {
      this->Rows[i].Name = this->Bones[i].Name;
      this->Rows[i].Input = PathBelow(this->Bones[i]);
      this->NameWidth = std::max(this->NameWidth, std::min(this->Rows[i].Name.size(), LongestName));
    }
  }

  ExitCode Run()
  {
    this->MakeFolder(this->Requested.Output);
    this->WriteCsv();
    this->Tell(BatchHeading(this->NameWidth));
    while (this->Next < this->Bones.size() || !this->Running.empty())
    {
      this->StartSome();
      this->CollectEnded();
      this->ShowProgress();
    }
    this->WriteCsv();
    this->Tell(BatchCounts(this->Rows) + "; table: " + this->CsvFile());
    StopIfInterrupted();
    return this->WorstCode();
  }

private:
  struct Job
  {
    Job(std::size_t bone, const std::string& self, const std::vector<std::string>& words)
      : Bone(bone)
      , Child(self, words)
    {
    }

    std::size_t Bone;
    ChildProcess Child;
  };

  /// Makes a folder, which is removed again if it ends up empty.
  void MakeFolder(const std::string& path)
  {
    std::error_code error;
    if (!std::filesystem::is_directory(FilePath(path), error))
    {
      this->Folders.emplace_back(path);
    }
  }

  void StartSome()
  {
    const auto jobs = static_cast<std::size_t>(std::max(this->Requested.Jobs, 1));
    for (; this->Next < this->Bones.size() && this->Running.size() < jobs && !IsInterrupted();
         ++this->Next)
    {
      const BatchBone& bone = this->Bones[this->Next];
      if (!bone.IsBone())
      {
        this->End(this->Next, "skipped", bone.CodeIfNot, bone.WhyNot);
      }
      else if (this->IsFinished(bone))
      {
        this->End(this->Next, "skipped", ExitCode::Done,
          "finished by an earlier run; --force does it again");
      }
      else
      {
        this->Start(this->Next);
      }
    }
    if (IsInterrupted())
    {
      this->Next = this->Bones.size();
      for (Job& job : this->Running)
      {
        job.Child.Interrupt();
      }
    }
  }

  bool IsFinished(const BatchBone& bone) const
  {
    ReportSubject subject = SubjectOf(this->Requested, bone.Input, bone.Output);
    subject.Given = OptionsFor(bone, this->Requested);
    return !this->Requested.Force && ReportMatches(bone.Report, bone.Output, subject);
  }

  void Start(std::size_t bone)
  {
    // A report that does not fit the output any more would make a later run skip a bone that failed
    // in this one.
    std::error_code ignored;
    std::filesystem::remove(FilePath(this->Bones[bone].Report), ignored);
    try
    {
      this->MakeFolder(FolderAround(this->Bones[bone].Output));
      this->Running.emplace_back(bone, this->Self, WordsFor(this->Bones[bone], this->Requested));
    }
    catch (const Failure& failure)
    {
      this->End(bone, "failed", failure.Code, failure.what());
    }
  }

  void CollectEnded()
  {
    const std::size_t before = this->Running.size();
    for (auto job = this->Running.begin(); job != this->Running.end();)
    {
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
      this->WriteCsv();
    }
    else if (!this->Running.empty())
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  void Note(const Job& job)
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
        return this->End(job.Bone, "skipped", ExitCode::Done, message);
      }
    }
    const bool stopped = code == ExitCode::Interrupted;
    this->End(job.Bone, code == ExitCode::Done ? "done" : (stopped ? "interrupted" : "failed"),
      code, job.Child.GetMessage());
  }

  /// What became of a bone, in its row and in a line.
  void End(std::size_t bone, const char* status, ExitCode code, const std::string& message)
  {
    BatchRow& row = this->Rows[bone];
    row.Status = status;
    row.Code = code;
    row.Message = message;
    if (this->Bones[bone].IsBone() && code == ExitCode::Done)
    {
      TakeReport(row, this->Bones[bone].Report);
    }
    this->Tell(BatchLine(row, this->NameWidth));
  }

  std::string CsvFile() const
  {
    return (FilePath(this->Requested.Output) / "summary.csv").string();
  }

  void WriteCsv() const { WriteTextFile(this->CsvFile(), ComposeCsv(this->Rows)); }

  void ShowProgress()
  {
    const std::size_t ended = this->Next - this->Running.size();
    if (this->Terminal && ended != this->Shown)
    {
      this->Shown = ended;
      std::cout << "\r" << ended << " of " << this->Bones.size() << " files" << std::flush;
    }
  }

  /// A line, in place of the progress.
  void Tell(const std::string& line) const
  {
    if (!this->Requested.Quiet)
    {
      if (this->Terminal)
      {
        std::fputs("\r\033[K", stdout); // the stream takes no commands of terminals
      }
      std::cout << line << '\n' << std::flush;
    }
  }

  ExitCode WorstCode() const
  {
    const auto worst = std::max_element(this->Rows.begin(), this->Rows.end(),
      [](const BatchRow& a, const BatchRow& b) { return a.Code < b.Code; });
    return worst->Code;
  }

  const Arguments& Requested;
  const std::string& Self;
  std::vector<BatchBone> Bones;
  std::vector<BatchRow> Rows;
  std::size_t NameWidth = 4; // of "name"
  std::list<StagedFolder> Folders;
  std::list<Job> Running;
  std::size_t Next = 0;
  std::size_t Shown = 0;
  bool Terminal;
};
}

ExitCode RunBatch(const Arguments& arguments, const std::string& self)
{
  return Batch(arguments, self).Run();
}
}
