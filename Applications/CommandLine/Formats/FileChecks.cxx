// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileChecks.h"

#include "ExitCode.h"
#include "FilePath.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace bonedecimate
{
void Reject(const std::string& path, const std::string& reason)
{
  throw Failure(ExitCode::InputRejected, "'" + path + "' was rejected: " + PrintableText(reason));
}

std::string PrintableText(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

void CheckFile(const std::string& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(FilePath(path), error);
  if (!fs::exists(status))
  {
    Reject(path,
      error && status.type() == fs::file_type::none ? error.message() : "there is no such file");
  }
  if (!fs::is_regular_file(status))
  {
    Reject(path, fs::is_directory(status) ? "it is a folder" : "it is not a regular file");
  }
  if (fs::file_size(FilePath(path), error) == 0)
  {
    Reject(path, "the file is empty (0 bytes)");
  }
  if (!std::ifstream(path, std::ios::binary))
  {
    Reject(path, std::strerror(errno));
  }
}
}
