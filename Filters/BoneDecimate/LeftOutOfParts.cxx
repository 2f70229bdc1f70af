// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LeftOutOfParts.cxx
 * @brief What a surface in parts left out, and the checksum of its result, from those of its parts.
 *
 *     numbers of a part     two halves of the checksum; then for each entry its count, and each of
 *                           its texts: length, bytes
 */
#include "LeftOutOfParts.h"

#include "Mesh/Checksum.h"
#include "RunState.h"
#include "SurfaceConversion.h"
#include "vtkBoneDecimate.h"

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

/// Entries of the same kind and noun are one; where its first one is, only the part knows.
void Join(LeftOut entry, std::vector<LeftOut>& all)
{
  const auto same = std::find_if(
    all.begin(), all.end(), [&](const LeftOut& other) { return other.Kind == entry.Kind; });
  if (same == all.end())
  {
    all.push_back(std::move(entry));
    return;
  }
  same->What = same->Count > 1 ? same->What : entry.What;
  same->Count += entry.Count;
  same->Where.clear();
}
}

void TakeFiguresOfParts(const std::vector<std::vector<double>>& ofParts, Report& report)
{
  for (const std::vector<double>& numbers : ofParts)
  {
    NumberReader reader(numbers);
    const auto high = static_cast<std::uint64_t>(reader.Next());
    report.OutputChecksum += high * HalfWord + static_cast<std::uint64_t>(reader.Next());
    while (!reader.IsAtEnd())
    {
      LeftOut entry;
      entry.Count = static_cast<std::int64_t>(reader.Next());
      entry.Kind = reader.NextText();
      entry.What = reader.NextText();
      Join(std::move(entry), report.LeftOut);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkBoneDecimate::Numbers vtkBoneDecimate::FiguresOfPart(
  const vtkBoneDecimate& run, vtkPolyData* output) const
{
  using namespace bonedecimate;
  const int threads = this->State->Options.NumberOfThreads;
  const std::uint64_t checksum = TriangleChecksum(ToSurface(output, threads).Surface, threads);
  const std::uint64_t high = checksum / HalfWord;
  const std::uint64_t low = checksum % HalfWord;
  Numbers numbers = { static_cast<double>(high), static_cast<double>(low) };
  for (const LeftOut& entry : run.State->Report.LeftOut)
  {
    numbers.push_back(static_cast<double>(entry.Count));
    AddText(entry.Kind, numbers);
    AddText(entry.What, numbers);
  }
  return numbers;
}
