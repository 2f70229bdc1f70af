// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolatedReader.h"

#include "CurrentFile.h"

#include <exception>
#include <new>

namespace bonedecimate::volume
{
struct IsolatedReader::Source
{
  LayeredVolume Volume;
};

/// There is no child to wait for.
void StopReadingBy(void (*)()) {}

IsolatedReader::IsolatedReader(const std::string& problem)
{
  this->Header.Problem = problem;
}

IsolatedReader::IsolatedReader(const std::function<LayeredVolume()>& open)
  : From(std::make_unique<Source>())
{
  ResetCurrentFile();
  try
  {
    this->From->Volume = open();
    this->Header = this->From->Volume.Header;
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    const std::string file = CurrentFile();
    this->Header.Problem = file.empty() ? "it is damaged" : DamagedFileProblem(file);
  }
}

IsolatedReader::~IsolatedReader() = default;

std::string IsolatedReader::ReadLayers(std::int64_t count, void* values)
{
  const std::size_t bytes = this->Header.BytesInALayer();
  std::string problem;
  for (std::int64_t k = 0; problem.empty() && k < count; ++k)
  {
    problem = this->From->Volume.ReadLayer(
      static_cast<char*>(values) + static_cast<std::size_t>(k) * bytes);
  }
  return problem;
}
}
