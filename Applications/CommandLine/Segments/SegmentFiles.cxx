// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SegmentFiles.h"

#include "Base/Text.h"
#include "Commands/CommandLine.h"
#include "ExitCode.h"
#include "FilePath.h"
#include "Files/FileNames.h"
#include "Files/PointPosition.h"
#include "Files/SameFile.h"
#include "Files/SurfaceFiles.h"
#include "Files/WrittenProof.h"
#include "FolderEntries.h"
#include "Formats/SurfaceFormat.h"
#include "NamedLabels.h"
#include "NumberText.h"
#include "ReportFields.h"
#include "SegmentOutput.h"
#include "Terminal/Interruption.h"

#include "vtkBoneSurfaces.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataConnectivityFilter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace bonedecimate
{
namespace
{
using Position = std::array<double, 3>;

/// Six times the signed volume between the triangle and the origin.
double Determinant(const Position& a, const Position& b, const Position& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Calls visit with the three corners of each triangle.
template <typename Visit>
void ForEachTriangle(vtkPolyData* surface, const Visit& visit)
{
  const auto cell = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cell->GetCurrentCell(size, corners);
    visit(corners);
  }
}

/// mm3, of each component, the largest first.
std::vector<double> VolumesOfComponents(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataConnectivityFilter> components;
  components->SetInputData(surface);
  components->SetExtractionModeToAllRegions();
  components->ColorRegionsOn();
  components->Update();
  vtkPolyData* const colored = components->GetOutput();
  vtkDataArray* const componentOf = colored->GetPointData()->GetArray("RegionId");
  const Position origin = colored->GetNumberOfPoints() > 0 ? PositionOf(colored, 0) : Position{};
  const auto offset = [&](vtkIdType point)
  {
    Position position = PositionOf(colored, point);
    std::transform(
      position.begin(), position.end(), origin.begin(), position.begin(), std::minus<>());
    return position;
  };
  std::vector<double> volumes(
    static_cast<std::size_t>(components->GetNumberOfExtractedRegions()), 0.0);
  ForEachTriangle(colored,
    [&](const vtkIdType* corners)
    {
      volumes[static_cast<std::size_t>(componentOf->GetComponent(corners[0], 0))] +=
        Determinant(offset(corners[0]), offset(corners[1]), offset(corners[2])) / 6.0;
    });
  std::sort(
    volumes.begin(), volumes.end(), [](double a, double b) { return std::abs(a) > std::abs(b); });
  return volumes;
}

/// A name as a file may have it: without what separates folders, what shells and other systems take
/// for something else, and blanks.
std::string NameInFolder(const NamedLabel& label)
{
  std::string name = label.Name;
  for (char& c : name)
  {
    const bool isControl = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    if (isControl || std::string(" /\\:*?\"<>|&'`$;").find(c) != std::string::npos)
    {
      c = '_';
    }
  }
  constexpr std::size_t longest = 100;
  const bool isUsable = !name.empty() && name.size() <= longest && name[0] != '.' && name[0] != '-';
  return isUsable ? name : "label_" + std::to_string(label.Value);
}

/// The names of the files without extension; those that would be the same get their labels, too.
std::vector<std::string> NamesInFolder(const std::vector<NamedLabel>& labels)
{
  std::multiset<std::string> all;
  for (const NamedLabel& label : labels)
  {
    all.insert(LowerCase(NameInFolder(label)));
  }
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const NamedLabel& label : labels)
  {
    const std::string number = "_" + std::to_string(label.Value);
    std::string name = NameInFolder(label);
    name += all.count(LowerCase(name)) > 1 ? number : std::string();
    while (!taken.insert(LowerCase(name)).second)
    {
      name += number;
    }
    names.push_back(name);
  }
  return names;
}

/// The file that has a block for each of the others.
std::string BlockFileText(const std::string& folder, const std::vector<SegmentRecord>& segments)
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"vtkMultiBlockDataSet\" "
                     "version=\"1.0\" byte_order=\"LittleEndian\">\n  <vtkMultiBlockDataSet>\n";
  int index = 0;
  for (const SegmentRecord& segment : segments)
  {
    if (!segment.File.empty())
    {
      const std::string name =
        segment.Label.Name.empty() ? std::to_string(segment.Label.Value) : segment.Label.Name;
      text += "    <DataSet index=\"" + std::to_string(index) + "\" name=\"" + EscapedXml(name) +
        "\" file=\"" + EscapedXml(folder + "/" + segment.File) + "\"/>\n";
      ++index;
    }
  }
  return text + "  </vtkMultiBlockDataSet>\n</VTKFile>\n";
}

/// The triangles of one label have its color on both sides of a wall.
void PaintTriangles(vtkPolyData* surface, const std::optional<LabelColor>& color)
{
  if (!color)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(ColorArray);
  colors->SetNumberOfComponents(3);
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    colors->InsertNextTypedTuple(color->data());
  }
  surface->GetCellData()->AddArray(colors);
}

/// mm3, of a voxel of the result's grid; 0 if it has none, or layers at uneven distances.
double VoxelVolumeOf(vtkPolyData* result)
{
  vtkFieldData* const fields = result->GetFieldData();
  vtkDataArray* const spacing = fields->GetArray("VoxelGridSpacing");
  if (!spacing || spacing->GetNumberOfValues() < 3 || fields->HasArray("VoxelGridLayers") != 0)
  {
    return 0.0;
  }
  double volume = 1.0;
  for (vtkIdType axis = 0; axis < 3; ++axis)
  {
    volume *= spacing->GetVariantValue(axis).ToDouble();
  }
  return volume;
}

/// Surfaces round off what is a voxel thin: a rod of single voxels loses half of its volume.
void WarnOfThinSegment(vtkPolyData* result, const SegmentRecord& segment, ReportSubject& subject)
{
  constexpr double kept = 0.75;
  const double voxels = ReportFields(result)
                          .Number("voxels.of_" + std::to_string(segment.Label.Value) + ".voxels")
                          .value_or(0.0);
  const double before = voxels * VoxelVolumeOf(result);
  const double after = std::accumulate(segment.Volumes.begin(), segment.Volumes.end(), 0.0);
  if (before > 0.0 && after < kept * before)
  {
    subject.Warnings.push_back("segment " + LabelText(segment.Label) +
      " is so thin that its surface has " + GroupedText(100.0 * after / before) +
      " % of the volume of its " + GroupedText(voxels) + " voxels");
  }
}

/// Surfaces in the folder of the segments that this run does not write, such as those of another
/// format.
void WarnOfOtherSurfaces(const Arguments& arguments, ReportSubject& subject)
{
  const std::string folder = FolderOfSegments(arguments);
  std::error_code error;
  std::vector<std::string> others;
  for (const fs::path& path : FolderEntries(FilePath(folder), error))
  {
    const std::string name = path.filename().string();
    const auto isIt = [&name](const SegmentRecord& segment) { return segment.File == name; };
    const auto isAlso = [&path](const std::string& file)
    { return IsSameFile(path.string(), file); };
    if (name[0] != '.' && FindFormat(name) != nullptr &&
      std::none_of(subject.Segments.begin(), subject.Segments.end(), isIt) &&
      std::none_of(arguments.Also.begin(), arguments.Also.end(), isAlso))
    {
      others.push_back(name);
    }
  }
  if (!others.empty())
  {
    subject.Warnings.push_back(
      "the folder has surfaces that are not of this run: " + QuotedList(others));
  }
}

/// Writes the files of the segments.
class SegmentWriter
{
public:
  SegmentWriter(
    const Arguments& arguments, bool isProved, OutputFiles& files, ReportSubject& subject)
    : Requested(arguments)
    , IsProved(isProved)
    , Files(files)
    , Subject(subject)
  {
  }

  void Write(vtkPolyData* surface, const std::string& name, SegmentRecord& record)
  {
    record.File = name + "." + ExtensionOfSegments(this->Requested);
    const std::string target =
      (FilePath(FolderOfSegments(this->Requested)) / FilePath(record.File)).string();
    RequireDistinct({ target }, { this->Requested.Inputs[0], this->Requested.Reference });
    StagedFile& file = this->Files.AddSegment(target);
    const auto readBack =
      WriteSurface(surface, file.GetTemporary(), target, this->Requested.CompressesGlb);
    if (this->IsProved)
    {
      RequireSameTriangles(surface, readBack, target);
      this->Subject.ProvedFiles[record.File] = "same_bits";
    }
    record.Bytes = static_cast<std::int64_t>(fs::file_size(FilePath(file.GetTemporary())));
    this->Subject.OutputBytes += record.Bytes;
  }

private:
  const Arguments& Requested;
  bool IsProved; // the whole surface, of which segments are parts
  OutputFiles& Files;
  ReportSubject& Subject;
};
}

void WriteSegments(
  vtkPolyData* result, const Arguments& arguments, OutputFiles& files, ReportSubject& subject)
{
  const std::vector<NamedLabel> labels = LabelsOf(result);
  const std::vector<std::string> names = NamesInFolder(labels);
  const bool isProved = !ReportFields(result).Text("proof.status").empty();
  SegmentWriter writer(arguments, isProved, files, subject);
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    StopIfInterrupted();
    SegmentRecord record;
    record.Label = labels[i];
    if (const auto changed = subject.Changed.find(labels[i].Value);
        changed != subject.Changed.end())
    {
      record.Changed = changed->second;
    }
    vtkNew<vtkPolyData> surface;
    vtkBoneSurfaces::ExtractLabel(result, labels[i].Value, surface);
    record.Triangles = surface->GetNumberOfPolys();
    record.Volumes = VolumesOfComponents(surface);
    if (record.Triangles == 0)
    {
      subject.Warnings.push_back("nothing is left of segment " + LabelText(labels[i]));
    }
    else if (WritesSegments(arguments))
    {
      PaintTriangles(surface, labels[i].Color);
      writer.Write(surface, names[i], record);
    }
    WarnOfThinSegment(result, record, subject);
    subject.Segments.push_back(record);
  }
  if (IsSegmentFolder(arguments))
  {
    WarnOfOtherSurfaces(arguments, subject);
  }
  if (files.Blocks)
  {
    files.Blocks->WriteText(BlockFileText(BaseName(FolderOfSegments(arguments)), subject.Segments));
  }
}
}
