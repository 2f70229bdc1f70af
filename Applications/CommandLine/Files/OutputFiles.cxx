// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFiles.h"

#include "ExitCode.h"
#include "FilePath.h"
#include "SameFile.h"
#include "Segments/SegmentOutput.h"

#include <filesystem>

namespace bonedecimate
{
OutputFiles::OutputFiles(const Arguments& arguments)
  : KeepsPicture(!arguments.Picture.empty())
{
  const auto reserve = [](std::optional<StagedFile>& file, const std::string& name)
  {
    if (!name.empty())
    {
      file.emplace(name);
    }
  };
  if (WritesSegments(arguments))
  {
    this->Folder.emplace(FolderOfSegments(arguments));
    reserve(this->Blocks, IsBlockFile(arguments.Output) ? arguments.Output : std::string());
  }
  else
  {
    this->Surfaces.emplace_back(arguments.Output);
  }
  for (const std::string& also : arguments.Also)
  {
    this->Surfaces.emplace_back(also);
  }
  const bool onlyForPage = arguments.Picture.empty() && !arguments.Page.empty();
  reserve(this->Heatmap, arguments.Heatmap);
  reserve(this->Page, arguments.Page); // before its picture, which is named after it
  reserve(this->Picture, onlyForPage ? arguments.Page + ".png" : arguments.Picture);
  reserve(this->Report, arguments.Report);
}

StagedFile& OutputFiles::AddSegment(const std::string& target)
{
  for (const StagedFile& surface : this->Surfaces)
  {
    RequireDistinct({ target, surface.GetTarget() }, {});
  }
  for (const std::optional<StagedFile>* file :
    { &this->Heatmap, &this->Page, &this->Picture, &this->Report })
  {
    if (*file)
    {
      RequireDistinct({ target, (*file)->GetTarget() }, {});
    }
  }
  return this->Segments.emplace_back(target);
}

std::vector<std::string> OutputFiles::Commit()
{
  std::vector<StagedFile*> files;
  for (std::list<StagedFile>* surfaces : { &this->Segments, &this->Surfaces })
  {
    for (StagedFile& surface : *surfaces)
    {
      files.push_back(&surface);
    }
  }
  if (!this->KeepsPicture)
  {
    this->Picture.reset();
  }
  // The report comes last: where it lies, the others lie already.
  for (std::optional<StagedFile>* file :
    { &this->Blocks, &this->Heatmap, &this->Picture, &this->Page, &this->Report })
  {
    if (file->has_value())
    {
      files.push_back(&**file);
    }
  }
  for (StagedFile* file : files)
  {
    file->Flush();
  }
  std::vector<std::string> names;
  for (StagedFile* file : files)
  {
    file->Commit();
    names.push_back(file->GetTarget());
  }
  return names;
}
}
