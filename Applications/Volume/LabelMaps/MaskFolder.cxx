// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "MaskFolder.h"

#include "BoneVolume.h"
#include "FilePath.h"
#include "FolderEntries.h"
#include "LabelFields.h"
#include "Segmentation.h"
#include "VolumeFile.h"

#include "vtkFieldData.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <system_error>
#include <vector>

namespace bonedecimate::volume
{
namespace
{
namespace fs = std::filesystem;

constexpr std::size_t MaxMasks = 1000;

/// Without hidden ones.
std::vector<fs::path> VisibleEntries(const std::string& folder)
{
  std::error_code ignored;
  std::vector<fs::path> entries = FolderEntries(FilePath(folder), ignored);
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                  [](const fs::path& entry) { return entry.filename().string()[0] == '.'; }),
    entries.end());
  return entries;
}

/// "femur_left" of "femur_left.nii.gz".
std::string StructureOf(const fs::path& file)
{
  const fs::path plain = file.extension() == ".gz" ? file.stem() : file.filename();
  return plain.stem().string();
}

bool DifferByMoreThanNumbers(const std::vector<fs::path>& files)
{
  std::set<std::string> names;
  for (const fs::path& file : files)
  {
    std::string name = StructureOf(file);
    name.erase(
      std::remove_if(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; }),
      name.end());
    names.insert(name);
  }
  return names.size() > 1;
}

bool AreOfOneGrid(const VolumeHeader& a, const VolumeHeader& b)
{
  const auto areEqual = [&](std::size_t axis)
  { return AreClose(a.Geometry.Steps[axis], b.Geometry.Steps[axis]); };
  const Vector3 moved = Difference(a.Geometry.Origin, b.Geometry.Origin);
  return a.Problem.empty() && b.Problem.empty() && a.Size == b.Size && a.Layers == b.Layers &&
    areEqual(0) && areEqual(1) && areEqual(2) && Length(moved) < 1e-3 * Length(a.Geometry.Steps[0]);
}

/// Reads a mask layer by layer.
class MaskReader
{
public:
  explicit MaskReader(const fs::path& file)
    : Reader(OpenVolume(file.string()))
  {
  }

  const VolumeHeader& Header() const { return this->Reader->GetHeader(); }

  /// Calls take with the index of each voxel that is not 0.
  /// @return What is wrong; empty if nothing is.
  template <typename Take>
  std::string Read(const Take& take)
  {
    const VolumeHeader& header = this->Header();
    std::vector<char> layer(header.Problem.empty() ? header.BytesInALayer() : 0);
    std::string problem = header.Problem;
    for (std::int64_t k = 0; k < header.Size[2] && problem.empty(); ++k)
    {
      problem = this->Reader->ReadLayers(1, layer.data());
      if (problem.empty() && !this->IsMask(layer, k, take))
      {
        problem = "it has more than one value besides 0, so it is no mask of one structure";
      }
    }
    return problem;
  }

  bool IsEmpty() const { return !this->HasValue; }

private:
  template <typename Take>
  bool IsMask(const std::vector<char>& layer, std::int64_t k, const Take& take)
  {
    bool isMask = true;
    switch (this->Header().ScalarType)
    {
      vtkTemplateMacro(isMask = this->TakeLayer<VTK_TT>(layer, k, take));
      default:
        isMask = false;
    }
    return isMask;
  }

  template <typename Scalar, typename Take>
  bool TakeLayer(const std::vector<char>& layer, std::int64_t k, const Take& take)
  {
    const std::int64_t count = this->Header().Size[0] * this->Header().Size[1];
    const auto* values = reinterpret_cast<const Scalar*>(layer.data()); // NOLINT: as they were read
    for (std::int64_t i = 0; i < count; ++i)
    {
      const auto value = static_cast<double>(values[i]);
      if (value == 0.0)
      {
        continue;
      }
      this->Value = this->HasValue ? this->Value : value;
      this->HasValue = true;
      if (!(value == this->Value))
      {
        return false;
      }
      take(static_cast<std::size_t>(k * count + i));
    }
    return true;
  }

  std::unique_ptr<IsolatedReader> Reader;
  bool HasValue = false;
  double Value = 0.0; // of the structure
};

bool FirstIsMask(const std::vector<fs::path>& files)
{
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < std::min(most, files.size()); ++i)
  {
    MaskReader reader(files[i]);
    if (!reader.Read([](std::size_t /*voxel*/) {}).empty())
    {
      return false;
    }
    if (!reader.IsEmpty())
    {
      return true;
    }
  }
  return true;
}

bool AreMasks(const std::vector<fs::path>& files)
{
  const bool areVolumes = files.size() >= 2 && files.size() <= MaxMasks &&
    std::all_of(files.begin(), files.end(),
      [](const fs::path& file)
      { return IsVolumeFile(file.string()) && !NeedsSpacing(file.string()); });
  if (!areVolumes || !DifferByMoreThanNumbers(files))
  {
    return false;
  }
  const VolumeHeader first = OpenVolume(files[0].string())->GetHeader();
  return std::all_of(files.begin() + 1, files.end(),
           [&first](const fs::path& file)
           { return AreOfOneGrid(first, OpenVolume(file.string())->GetHeader()); }) &&
    FirstIsMask(files);
}
}

bool HoldsMasks(const std::string& folder)
{
  static std::map<std::string, bool> known; // it is queried many times
  const auto found = known.find(folder);
  return found != known.end()
    ? found->second
    : known.emplace(folder, AreMasks(VisibleEntries(folder))).first->second;
}

Volume ReadMasks(const std::string& folder, const SegmentSelection& selection)
{
  const std::vector<fs::path> files = VisibleEntries(folder);
  std::vector<Segment> segments(files.size());
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    segments[i].Label = static_cast<std::int64_t>(i) + 1;
    segments[i].Name = StructureOf(files[i]);
  }
  const std::vector<bool> isChosen = ChosenSegments(segments, selection);
  const VolumeHeader first = OpenVolume(files.at(0).string())->GetHeader();
  Volume volume;
  volume.Geometry = first.Geometry;
  volume.Layers = first.Layers;
  volume.Image = AllocateImage(first.Size, VTK_UNSIGNED_SHORT);
  auto* labels = static_cast<unsigned short*>(volume.Image->GetScalarPointer());
  const auto voxels = static_cast<std::size_t>(first.Size[0] * first.Size[1] * first.Size[2]);
  std::fill_n(labels, voxels, static_cast<unsigned short>(0));
  std::vector<bool> isCovered(voxels, false); // by more than one mask
  Overlap overlap;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    if (!isChosen[i])
    {
      continue;
    }
    MaskReader reader(files[i]);
    const std::string problem = AreOfOneGrid(first, reader.Header())
      ? reader.Read(
          [&](std::size_t voxel)
          {
            overlap.Voxels += labels[voxel] != 0 && !isCovered[voxel] ? 1 : 0;
            isCovered[voxel] = labels[voxel] != 0;
            labels[voxel] = static_cast<unsigned short>(i + 1);
          })
      : "its grid is not that of the other masks";
    if (!problem.empty())
    {
      return RejectedVolume(files[i].filename().string() + ": " + problem);
    }
  }
  volume.Note = first.Note;
  AppendNote(volume.Note, OverlapNote(overlap));
  AddLabelFields(segments, volume.Image->GetFieldData());
  volume.Image->GetFieldData()->RemoveArray(LabelNumberNames[1]); // masks have no colors
  return volume;
}
}
