// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Batch.h"

#include "BatchPlan.h"
#include "BatchTable.h"
#include "ChildProcess.h"
#include "FileNames.h"
#include "Interruption.h"
#include "JsonReport.h"
#include "StagedFile.h"

#include <algorithm>
#include <chrono>
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
  if (std::filesystem::is_directory(output, ignored))
  {
    RemoveStagedFilesOf(process, output);
    std::filesystem::remove(output, ignored); // only if it is empty
  }
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
      this->Rows[i].Input = BaseName(this->Bones[i].Input);
      this->Rows[i].Report = this->Bones[i].Report;
      if (!this->Bones[i].IsBone())
      {
        this->Rows[i].Status = "skipped";
        this->Rows[i].Code = this->Bones[i].CodeIfNot;
        this->Rows[i].Message = this->Bones[i].WhyNot;
      }
    }
  }

  ExitCode Run()
  {
    this->MakeFolder();
    this->WriteCsv();
    while (this->Next < this->Bones.size() || !this->Running.empty())
    {
      this->StartSome();
      this->CollectEnded();
      this->ShowProgress();
    }
    this->WriteCsv();
    this->Tell();
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

  void MakeFolder()
  {
    std::error_code error;
    std::filesystem::create_directories(this->Requested.Output, error);
    if (error)
    {
      throw Failure(ExitCode::CouldNotWrite,
        "could not make '" + this->Requested.Output + "': " + error.message());
    }
  }

  void StartSome()
  {
    const auto jobs = static_cast<std::size_t>(std::max(this->Requested.Jobs, 1));
    for (; this->Next < this->Bones.size() && this->Running.size() < jobs && !IsInterrupted();
         ++this->Next)
    {
      const BatchBone& bone = this->Bones[this->Next];
      if (bone.IsBone() && this->IsFinished(bone))
      {
        this->Rows[this->Next].Status = "skipped";
        this->Rows[this->Next].Code = ExitCode::Done;
        this->Rows[this->Next].Message = "finished by an earlier run; --force does it again";
      }
      else if (bone.IsBone())
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
    std::filesystem::remove(this->Bones[bone].Report, ignored);
    try
    {
      this->Running.emplace_back(bone, this->Self, WordsFor(this->Bones[bone], this->Requested));
    }
    catch (const Failure& failure)
    {
      this->Rows[bone].Status = "failed";
      this->Rows[bone].Code = failure.Code;
      this->Rows[bone].Message = failure.what();
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
      RemoveStagedFilesOf(job.Child.GetProcess(), this->Requested.Output);
      RemoveSegmentFolder(job.Child.GetProcess(), bone.Output);
    }
    BatchRow& row = this->Rows[job.Bone];
    row.Code = job.Child.GetCode();
    row.Message = job.Child.GetMessage();
    const bool stopped = row.Code == ExitCode::Interrupted;
    row.Status = row.Code == ExitCode::Done ? "done" : (stopped ? "interrupted" : "failed");
  }

  void WriteCsv() const
  {
    const std::filesystem::path folder(this->Requested.Output);
    WriteTextFile((folder / "summary.csv").string(), ComposeCsv(this->Rows));
  }

  void ShowProgress()
  {
    const std::size_t ended = this->Next - this->Running.size();
    if (this->Terminal && ended != this->Shown)
    {
      this->Shown = ended;
      std::cout << "\r" << ended << " of " << this->Bones.size() << " files" << std::flush;
    }
  }

  void Tell() const
  {
    if (this->Terminal)
    {
      std::cout << "\r\033[K";
    }
    if (!this->Requested.Quiet)
    {
      PrintTable(this->Rows);
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
