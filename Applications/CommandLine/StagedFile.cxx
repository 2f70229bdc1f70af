// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StagedFile.h"

#include "ExitCode.h"
#include "SurfaceFormat.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>
#include <vector>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
[[noreturn]] void Fail(const std::string& target, const std::string& reason)
{
  throw Failure(ExitCode::CouldNotWrite, "could not write '" + target + "': " + reason);
}

/// What the name stands for; a link keeps pointing, the file behind it is replaced.
fs::path ResolvedTarget(const std::string& target)
{
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    Fail(target, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
  }
  const fs::path resolved = fs::exists(status) ? fs::canonical(target, error) : fs::path(target);
  return error ? fs::path(target) : resolved;
}

std::string PrefixOf(int process)
{
  return ".bonedecimate-" + std::to_string(process) + "-";
}

std::string TemporaryName(const fs::path& target, int attempt)
{
  // The leading dot keeps it out of a batch that reads the folder.
  fs::path name = PrefixOf(getpid()) + std::to_string(attempt);
  // In small letters: VTK's PLY writer appends ".ply" to any other name.
  name += target.has_extension() ? "." + ExtensionOf(target.string()) : "";
  return (target.parent_path() / name).string();
}
}

StagedFile::StagedFile(const std::string& target)
  : Target(target)
  , Resolved(ResolvedTarget(target).string())
{
  for (int attempt = 0; this->Temporary.empty(); ++attempt)
  {
    const std::string name = TemporaryName(this->Resolved, attempt);
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0)
    {
      close(file);
      this->Temporary = name;
    }
    else if (errno != EEXIST)
    {
      Fail(target, std::strerror(errno));
    }
  }
}

StagedFile::~StagedFile()
{
  std::error_code ignored;
  if (!this->Temporary.empty())
  {
    fs::remove(this->Temporary, ignored);
  }
}

void StagedFile::WriteText(const std::string& text)
{
  std::ofstream stream(this->Temporary, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream)
  {
    Fail(this->Target, errno ? std::strerror(errno) : "the disk may be full");
  }
}

void StagedFile::Flush()
{
  const int file = open(this->Temporary.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = file >= 0 && fsync(file) == 0;
  const int reason = errno;
  if (file >= 0)
  {
    close(file);
  }
  if (!flushed)
  {
    Fail(this->Target, std::strerror(reason));
  }
}

void StagedFile::Commit()
{
  std::error_code error;
  fs::rename(this->Temporary, this->Resolved, error);
  if (error)
  {
    Fail(this->Target, error.message());
  }
  this->Temporary.clear();
}

void RemoveStagedFilesOf(int process, const std::string& folder)
{
  std::vector<fs::path> left;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
  {
    if (entry.path().filename().string().rfind(PrefixOf(process), 0) == 0)
    {
      left.push_back(entry.path());
    }
  }
  for (const fs::path& path : left)
  {
    fs::remove(path, ignored);
  }
}

void WriteTextFile(const std::string& target, const std::string& text)
{
  StagedFile file(target);
  file.WriteText(text);
  file.Flush();
  file.Commit();
}
}
