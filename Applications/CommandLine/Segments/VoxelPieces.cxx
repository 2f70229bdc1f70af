// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VoxelPieces.h"

#include "Arguments/Arguments.h"
#include "Arguments/CommonOptions.h"
#include "NamedLabels.h"
#include "NumberText.h"
#include "Options/NumberRange.h"
#include "Runs/FilterRun.h"

#include "vtkBoneLabelPieces.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <type_traits>

namespace bonedecimate
{
namespace
{
ChangedPieces PiecesOf(vtkBoneLabelPieces* filter, std::int64_t label)
{
  return { filter->GetNumberOfIslands(label), filter->GetNumberOfIslandVoxels(label),
    filter->GetVolumeOfIslands(label), filter->GetNumberOfCavities(label),
    filter->GetNumberOfCavityVoxels(label), filter->GetVolumeOfCavities(label) };
}

template <typename Scalar>
void MarkFrom(const Scalar* values, double gray, vtkUnsignedCharArray* mask)
{
  for (vtkIdType i = 0; i < mask->GetNumberOfTuples(); ++i)
  {
    mask->SetValue(i, static_cast<double>(values[i]) >= gray ? 1 : 0);
  }
}

/// Gives the voxels that are in the mask but below the gray value a value that is not.
template <typename Scalar>
void RaiseTo(double gray, vtkDataArray* mask, Scalar* values)
{
  const auto raised = static_cast<Scalar>(std::is_integral_v<Scalar> ? std::ceil(gray) : gray);
  const Scalar next = static_cast<double>(raised) < gray // by rounding to single precision
    ? static_cast<Scalar>(std::nextafter(static_cast<float>(raised), HUGE_VALF))
    : raised;
  for (vtkIdType i = 0; i < mask->GetNumberOfTuples(); ++i)
  {
    if (mask->GetComponent(i, 0) > 0.0 && static_cast<double>(values[i]) < gray)
    {
      values[i] = next;
    }
  }
}

vtkSmartPointer<vtkImageData> MaskFrom(vtkImageData* image, vtkImageData* grid, double gray)
{
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("Bone");
  mask->SetNumberOfTuples(values->GetNumberOfTuples());
  switch (values->GetDataType())
  {
    vtkTemplateMacro(MarkFrom(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), gray, mask));
    default:
      break;
  }
  const auto bone = vtkSmartPointer<vtkImageData>::New();
  bone->CopyStructure(grid);
  bone->GetFieldData()->ShallowCopy(grid->GetFieldData());
  bone->GetPointData()->SetScalars(mask);
  return bone;
}

ChangedPieces FillCavities(
  vtkImageData* image, vtkImageData* grid, double gray, double largestVolume)
{
  vtkNew<vtkBoneLabelPieces> pieces;
  pieces->SetInputData(MaskFrom(image, grid, gray));
  pieces->SetCavityVolume(largestVolume);
  UpdateFilter(pieces, Progress::Hidden);
  vtkDataArray* const mask = pieces->GetOutput()->GetPointData()->GetScalars();
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  switch (values->GetDataType())
  {
    vtkTemplateMacro(RaiseTo(gray, mask, static_cast<VTK_TT*>(values->GetVoidPointer(0))));
    default:
      break;
  }
  return PiecesOf(pieces, 1);
}

std::string CountText(
  std::int64_t pieces, const char* one, const char* several, std::int64_t voxels, double volume)
{
  return GroupedText(static_cast<double>(pieces)) + " " + (pieces == 1 ? one : several) + " of " +
    GroupedText(static_cast<double>(voxels)) + (voxels == 1 ? " voxel (" : " voxels (") +
    SizeText(volume) + " mm3)";
}
}

void AddFillVolume(CLI::App& app, Arguments& arguments)
{
  AddNumber(app,
    { "--fill-volume", "MM3", { 0, MaxNumber, false, "mm3" },
      "Volumes: fill cavities of a segment, or of the bone at --iso, up to this volume. Cavities "
      "are voxels of background that do not reach the end of the volume. 0, the default: fill "
      "none." },
    [&arguments](double volume)
    {
      arguments.FillVolume = volume;
      arguments.Given["fill-volume"] = NumberText(volume);
    });
}

vtkSmartPointer<vtkImageData> ChangePieces(vtkImageData* map, const std::vector<NamedLabel>& labels,
  const Arguments& arguments, PiecesOfLabels& changed, std::vector<std::string>& warnings)
{
  if (!arguments.Options.Prunes() && !(arguments.FillVolume > 0.0))
  {
    return map;
  }
  vtkNew<vtkBoneLabelPieces> pieces;
  pieces->SetInputData(map);
  pieces->SetIslandSize(arguments.Options.PruneSize);
  pieces->SetIslandArea(arguments.Options.PruneArea);
  pieces->SetIslandVolume(arguments.Options.PruneVolume);
  pieces->SetCavityVolume(arguments.FillVolume);
  for (const NamedLabel& label : labels)
  {
    pieces->AddLabel(label.Value);
  }
  AcceptMessages(UpdateFilter(pieces, Progress::Hidden), arguments.Inputs[0], warnings);
  for (const NamedLabel& label : labels)
  {
    changed[label.Value] = PiecesOf(pieces, label.Value);
    if (pieces->IsLargestPieceTooSmall(label.Value))
    {
      warnings.push_back("the largest piece of segment " + LabelText(label) +
        " is below a limit of --prune, too; it stays");
    }
  }
  return pieces->GetOutput();
}

VoxelChange CavityFilling(const Arguments& arguments, PiecesOfLabels& changed)
{
  if (!(arguments.FillVolume > 0.0))
  {
    return {};
  }
  return [gray = *arguments.Iso, volume = arguments.FillVolume, &changed](vtkImageData* image,
           vtkImageData* grid) { changed[1] = FillCavities(image, grid, gray, volume); };
}

std::string ChangesText(const ChangedPieces& changed)
{
  std::string text;
  if (changed.Islands > 0)
  {
    text =
      CountText(changed.Islands, "island", "islands", changed.IslandVoxels, changed.IslandVolume) +
      " removed";
  }
  if (changed.Cavities > 0)
  {
    text += (text.empty() ? "" : ", ") +
      CountText(
        changed.Cavities, "cavity", "cavities", changed.CavityVoxels, changed.CavityVolume) +
      " filled";
  }
  return text;
}

std::vector<std::string> ChangesTexts(const PiecesOfLabels& changed, bool areLabels)
{
  std::vector<std::string> texts;
  for (const auto& [label, pieces] : changed)
  {
    const std::string text = ChangesText(pieces);
    texts.push_back((areLabels ? "label " + std::to_string(label) : std::string("bone")) + ": " +
      (text.empty() ? "nothing" : text));
  }
  return texts;
}

nlohmann::ordered_json JsonOfPieces(const ChangedPieces& changed)
{
  const auto piece = [](std::int64_t count, std::int64_t voxels,
                       double volume) -> nlohmann::ordered_json {
    return { { "count", count }, { "voxels", voxels }, { "volume", volume } };
  };
  return { { "islands_removed",
             piece(changed.Islands, changed.IslandVoxels, changed.IslandVolume) },
    { "cavities_filled", piece(changed.Cavities, changed.CavityVoxels, changed.CavityVolume) } };
}
}
