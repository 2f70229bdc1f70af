// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FolderTable.h"

#include "ExitCode.h"
#include "FilePath.h"
#include "FolderRows.h"

#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

namespace bonedecimate
{
namespace
{
/// Nothing if the folder is not there, or a part of it cannot be read.
std::vector<BatchRow> RowsThatAreThere(const std::string& folder)
{
  std::error_code ignored;
  if (!std::filesystem::is_directory(FilePath(folder), ignored))
  {
    return {};
  }
  try
  {
    return RowsOfFolder(folder);
  }
  catch (const Failure&)
  {
    return {};
  }
}
}

FolderTable::FolderTable(const std::string& folder, const std::vector<BatchBone>& bones)
  : Folder(folder)
{
  std::set<std::string> names, inputs;
  for (const BatchBone& bone : bones)
  {
    names.insert(bone.Name);
    if (bone.IsBone())
    {
      inputs.insert(PathBelow(bone));
    }
  }
  for (BatchRow& row : RowsThatAreThere(folder))
  {
    if (names.count(row.Name) == 0 && inputs.count(row.Input) == 0)
    {
      this->Others.push_back(std::move(row));
    }
  }
}

//------------------------------------------------------------------------------
void FolderTable::Write(const std::vector<BatchRow>& rows)
{
  std::vector<BatchRow> all = rows;
  all.insert(all.end(), this->Others.begin(), this->Others.end());
  this->Problem.clear();
  try
  {
    this->File = WriteTables(this->Folder, all);
  }
  catch (const Failure& failure)
  {
    this->Problem = failure.what();
  }
}

//------------------------------------------------------------------------------
void FolderTable::Require() const
{
  if (this->HasProblem())
  {
    throw Failure(ExitCode::CouldNotWrite, this->Problem);
  }
}
}
