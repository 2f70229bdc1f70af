// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FiguresOfParts.cxx
 * @brief Figures of a part as numbers that can be sent to other processes.
 *
 *     numbers of a part     two halves of the checksum of its result; counts of edits, and the
 *                           status of the drafts; then for each entry of what was left out its
 *                           count, and each of its texts: length, bytes
 */
#include "FiguresOfParts.h"

#include "DecimateInternals.h"
#include "Mesh/Checksum.h"
#include "Run/Report/MergeReports.h"
#include "RunState.h"
#include "SurfaceConversion.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace bonedecimate
{
namespace
{
constexpr std::uint64_t HalfWord = 1ULL << 32U;

void AddText(const std::string& text, std::vector<double>& numbers)
{
  numbers.push_back(static_cast<double>(text.size()));
  numbers.insert(numbers.end(), text.begin(), text.end());
}

/// Reads numbers one after the other.
class NumberReader
{
public:
  explicit NumberReader(const std::vector<double>& numbers)
    : Numbers(numbers)
  {
  }
  bool IsAtEnd() const { return this->At >= this->Numbers.size(); }
  double Next() { return this->IsAtEnd() ? 0.0 : this->Numbers[this->At++]; }
  std::string NextText()
  {
    std::string text(static_cast<std::size_t>(this->Next()), ' ');
    std::generate(text.begin(), text.end(), [this] { return static_cast<char>(this->Next()); });
    return text;
  }

private:
  const std::vector<double>& Numbers;
  std::size_t At = 0;
};

std::vector<std::int64_t*> CountsOf(EditFigures& edits)
{
  std::vector<std::int64_t*> counts = { &edits.Collapses, &edits.Draft.Collapses,
    &edits.Draft.Undone, &edits.Forced.Tried, &edits.Forced.Made };
  for (std::int64_t& rejections : edits.Rejections)
  {
    counts.push_back(&rejections);
  }
  return counts;
}

std::vector<double> ToNumbers(Report part)
{
  const std::uint64_t high = part.OutputChecksum / HalfWord;
  const std::uint64_t low = part.OutputChecksum % HalfWord;
  std::vector<double> numbers = { static_cast<double>(high), static_cast<double>(low) };
  for (const std::int64_t* count : CountsOf(part.Edits))
  {
    numbers.push_back(static_cast<double>(*count));
  }
  numbers.push_back(static_cast<double>(part.Edits.Draft.Status));
  for (const LeftOut& entry : part.LeftOut)
  {
    numbers.push_back(static_cast<double>(entry.Count));
    AddText(entry.Kind, numbers);
    AddText(entry.What, numbers);
  }
  return numbers;
}

Report FromNumbers(const std::vector<double>& numbers)
{
  NumberReader reader(numbers);
  Report part;
  const auto high = static_cast<std::uint64_t>(reader.Next());
  part.OutputChecksum = high * HalfWord + static_cast<std::uint64_t>(reader.Next());
  for (std::int64_t* count : CountsOf(part.Edits))
  {
    *count = static_cast<std::int64_t>(reader.Next());
  }
  part.Edits.Draft.Status = static_cast<DraftStatus>(static_cast<int>(reader.Next()));
  while (!reader.IsAtEnd())
  {
    LeftOut entry;
    entry.Count = static_cast<std::int64_t>(reader.Next());
    entry.Kind = reader.NextText();
    entry.What = reader.NextText();
    part.LeftOut.push_back(std::move(entry));
  }
  return part;
}
}

void TakeFiguresOfParts(const std::vector<std::vector<double>>& ofParts, Report& report)
{
  for (const std::vector<double>& numbers : ofParts)
  {
    AddPart(FromNumbers(numbers), report);
  }
}
}

//------------------------------------------------------------------------------
void vtkBoneDecimate::Internals::AddRun(const vtkBoneDecimate& run)
{
  bonedecimate::Report part;
  part.Edits = run.State->Report.Edits;
  part.LeftOut = run.State->Report.LeftOut;
  bonedecimate::AddPart(part, this->Filter->State->Report);
}

//------------------------------------------------------------------------------
vtkBoneDecimate::Internals::Numbers vtkBoneDecimate::Internals::FiguresOfPart(
  vtkPolyData* output) const
{
  using namespace bonedecimate;
  const int threads = this->Filter->State->Options.NumberOfThreads;
  Report part;
  part.Edits = this->Filter->State->Report.Edits;
  part.LeftOut = this->Filter->State->Report.LeftOut;
  part.OutputChecksum = TriangleChecksum(ToSurface(output, threads).Surface, threads);
  return ToNumbers(std::move(part));
}
