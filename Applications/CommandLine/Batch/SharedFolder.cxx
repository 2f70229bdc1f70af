// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SharedFolder.h"

#include "FilePath.h"
#include "FolderEntries.h"

#include <algorithm>
#include <fstream>
#include <random>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
constexpr std::chrono::seconds RenewedEvery(10);
constexpr std::chrono::seconds AliveFor(60);

/// A change of what is in a folder gives it the time of its file system.
void Touch(const fs::path& folder)
{
  std::error_code ignored;
  fs::create_directory(folder / "touch", ignored);
  fs::remove(folder / "touch", ignored);
}

const char* const OptionsFile = "options";

/// Nothing if the file cannot be read.
std::optional<std::string> TextOf(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::getline(stream, text, '\0');
  return stream.bad() || !stream.is_open() ? std::nullopt : std::optional<std::string>(text);
}

std::string RandomNumber()
{
  std::random_device device;
  return std::to_string(device()) + std::to_string(device());
}

/// The folder of a batch: others see it with its options or not at all.
std::error_code MakeFolder(const fs::path& folder, const std::string& options)
{
  std::error_code error;
  const fs::path beginning = folder.string() + ".new";
  fs::create_directories(beginning, error);
  if (!error)
  {
    std::ofstream(beginning / OptionsFile, std::ios::binary) << options;
    fs::rename(beginning, folder, error);
  }
  return error;
}
}

SharedFolder::SharedFolder(const std::string& output, const std::string& options)
  : Hidden(FilePath(output) / ".bonedecimate")
  , Own(Hidden / (RandomNumber() + ".batch"))
  , Renewed(std::chrono::steady_clock::now())
{
  std::error_code error = MakeFolder(this->Own, options);
  if (error)
  {
    error = MakeFolder(this->Own, options); // another batch ended and removed the folder around it
  }
  Touch(this->Own);
  this->Begin = error ? Time() : fs::last_write_time(this->Own, error);
  if (error)
  {
    throw Failure(
      ExitCode::CouldNotWrite, "could not write into '" + output + "': " + error.message());
  }
  for (const Path& other : this->OtherBatches())
  {
    const std::optional<std::string> ofOther = TextOf(other / OptionsFile);
    if (ofOther && *ofOther != options)
    {
      fs::remove_all(this->Own, error);
      throw Failure(ExitCode::Usage,
        "'" + output + "' is in use by a batch with other options" +
          (ofOther->empty() ? std::string() : " (" + *ofOther + ")") +
          ", or was until a minute ago");
    }
  }
}

//------------------------------------------------------------------------------
SharedFolder::~SharedFolder()
{
  std::error_code ignored;
  for (const Path& claim : this->Claims)
  {
    fs::remove_all(claim, ignored);
  }
  if (!this->HasOthers())
  {
    fs::remove_all(this->Hidden, ignored);
  }
  fs::remove_all(this->Own, ignored);
}

//------------------------------------------------------------------------------
bool SharedFolder::HasOthers() const
{
  Touch(this->Own);
  return !this->OtherBatches().empty();
}

//------------------------------------------------------------------------------
bool SharedFolder::Claim(const std::string& name)
{
  const Path claim = this->PathOf(name, ".claim");
  std::error_code error;
  fs::create_directories(claim.parent_path(), error);
  const bool isOwn = fs::create_directory(claim, error) ||
    (this->RemoveDead(claim) && fs::create_directory(claim, error));
  if (error)
  {
    throw Failure(
      ExitCode::CouldNotWrite, "could not write '" + claim.string() + "': " + error.message());
  }
  if (isOwn)
  {
    this->Claims.insert(claim);
    fs::remove(this->PathOf(name, ".failed"), error);
  }
  return isOwn;
}

//------------------------------------------------------------------------------
void SharedFolder::Release(const std::string& name)
{
  const Path claim = this->PathOf(name, ".claim");
  std::error_code ignored;
  fs::remove_all(claim, ignored);
  this->Claims.erase(claim);
}

//------------------------------------------------------------------------------
void SharedFolder::Renew()
{
  const auto now = std::chrono::steady_clock::now();
  if (now - this->Renewed > RenewedEvery)
  {
    this->Renewed = now;
    Touch(this->Own);
    for (const Path& claim : this->Claims)
    {
      Touch(claim);
    }
  }
}

//------------------------------------------------------------------------------
void SharedFolder::NoteFailure(const std::string& name, const InputFailure& failure) const
{
  std::ofstream file(this->PathOf(name, ".failed"), std::ios::binary);
  file << static_cast<int>(failure.Code) << " " << failure.Message;
}

//------------------------------------------------------------------------------
std::optional<SharedFolder::InputFailure> SharedFolder::FailureOf(const std::string& name) const
{
  const Path path = this->PathOf(name, ".failed");
  std::ifstream file(path, std::ios::binary);
  int code = 0;
  InputFailure failure{ ExitCode::Done, "" };
  if (!(file >> code) || !this->IsNew(path.string()))
  {
    return std::nullopt;
  }
  file.get();
  std::getline(file, failure.Message, '\0');
  failure.Code = static_cast<ExitCode>(code);
  return failure;
}

//------------------------------------------------------------------------------
bool SharedFolder::IsNew(const std::string& file) const
{
  std::error_code error;
  const Time time = fs::last_write_time(FilePath(file), error);
  return !error && time > this->Begin; // on Windows they are whole seconds
}

//------------------------------------------------------------------------------
/// In the same folders as the outputs: their names may be as long as a file system allows.
SharedFolder::Path SharedFolder::PathOf(const std::string& name, const char* extension) const
{
  return this->Hidden / FilePath(name + extension);
}

//------------------------------------------------------------------------------
/// By the time of this batch's own folder, which was renewed a moment ago.
bool SharedFolder::IsAlive(const Path& folder) const
{
  std::error_code error;
  const Time time = fs::last_write_time(folder, error);
  return !error && time + AliveFor > fs::last_write_time(this->Own, error);
}

//------------------------------------------------------------------------------
/// Whether the claim was dead and this batch removed it. It is renamed first, which works for one
/// batch alone.
bool SharedFolder::RemoveDead(const Path& folder) const
{
  Touch(this->Own);
  if (this->IsAlive(folder))
  {
    return false;
  }
  const Path dead = folder.string() + "." + RandomNumber();
  std::error_code error;
  fs::rename(folder, dead, error);
  if (error)
  {
    return false;
  }
  fs::remove_all(dead, error);
  return true;
}

//------------------------------------------------------------------------------
/// Those at work.
std::vector<SharedFolder::Path> SharedFolder::OtherBatches() const
{
  std::error_code error;
  std::vector<Path> entries = FolderEntries(this->Hidden, error);
  entries.erase(
    std::remove_if(entries.begin(), entries.end(),
      [this](const Path& entry)
      { return entry.extension() != ".batch" || entry == this->Own || !this->IsAlive(entry); }),
    entries.end());
  return entries;
}
}
