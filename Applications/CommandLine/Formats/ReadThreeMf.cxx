// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// The model passes from the archive to the parser in small pieces, so that a damaged archive
/// cannot claim much memory.
#ifdef BONEDECIMATE_HAS_LIBZIP

#include "FileChecks.h"
#include "FileParts.h"
#include "FilePath.h"
#include "LeftOutOfReader.h"
#include "ThreeMfFiles.h"
#include "ThreeMfModel.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <zip.h>

namespace bonedecimate
{
namespace
{
using ZipArchive = std::unique_ptr<zip_t, void (*)(zip_t*)>;

/// What the build of a package makes of its objects.
class ThreeMfReader
{
public:
  explicit ThreeMfReader(const std::string& path)
    : Path(path)
    , Zip(nullptr, zip_discard)
  {
    int error = 0;
    this->Zip.reset(zip_open(path.c_str(), ZIP_RDONLY, &error));
    if (this->Zip == nullptr)
    {
      Reject(path, "it is not a ZIP archive, or it is cut off");
    }
    constexpr double mostRepeated = 20.0; // times the file
    constexpr double alwaysAllowed = 1e9; // bytes
    this->BytesLeft = std::max(alwaysAllowed,
      mostRepeated * static_cast<double>(std::filesystem::file_size(FilePath(path))));
  }

  vtkSmartPointer<vtkPolyData> Run(std::vector<std::string>& warnings)
  {
    const std::string start = this->FindStart();
    const ThreeMfPart& model = this->PartAt(start);
    if (model.Build.empty())
    {
      Reject(this->Path, "its build has no item, so that it is no surface");
    }
    for (const ThreeMfReference& item : model.Build)
    {
      if (item.IsPrintable)
      {
        this->AddObject(item, start, {}, 0);
      }
      else
      {
        ++this->NotPrintable;
        this->UsedObjects.insert({ this->KeyOf(item, start), item.Object });
      }
    }
    const vtkSmartPointer<vtkPolyData> surface = JoinParts(this->Parts);
    this->Warn(warnings, surface);
    return surface;
  }

private:
  static std::string KeyOf(const ThreeMfReference& reference, const std::string& part)
  {
    std::string key = reference.Path.empty() ? part : reference.Path;
    key.erase(0, key.find_first_not_of('/'));
    return key;
  }

  /// Hands a file of the archive to the parser; false if it is not there.
  bool Parse(const std::string& name, ThreeMfParser& parser)
  {
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen(this->Zip.get(), name.c_str(), ZIP_FL_NOCASE), zip_fclose);
    if (file == nullptr)
    {
      return false;
    }
    constexpr std::size_t firstBytes = 1U << 16;
    constexpr std::size_t mostBytes = 1U << 26;
    std::string piece(firstBytes, '\0');
    std::string problem;
    zip_int64_t count = 0;
    while (problem.empty() && (count = zip_fread(file.get(), piece.data(), piece.size())) > 0)
    {
      problem = parser.Add({ piece.data(), static_cast<std::size_t>(count) });
      // The parser begins again with what a piece cuts in two, such as a long attribute.
      piece.resize(std::min(2 * piece.size(), mostBytes));
    }
    const std::string ending = parser.Finish();
    problem = problem.empty() ? ending : problem;
    if (!problem.empty() || count != 0)
    {
      Reject(this->Path, problem.empty() ? "its model is damaged" : problem);
    }
    return true;
  }

  /// The model that the package names, or the usual one.
  std::string FindStart()
  {
    ThreeMfParser relationships;
    std::string start;
    if (zip_name_locate(this->Zip.get(), "_rels/.rels", ZIP_FL_NOCASE) >= 0 &&
      this->Parse("_rels/.rels", relationships))
    {
      start = relationships.StartPart();
    }
    start.erase(0, start.find_first_not_of('/'));
    return start.empty() ? ThreeMfModel : start;
  }

  ThreeMfPart& PartAt(const std::string& name)
  {
    const auto known = this->Models.find(name);
    if (known != this->Models.end())
    {
      return known->second;
    }
    ThreeMfParser parser;
    if (!this->Parse(name, parser))
    {
      Reject(this->Path, "it has no " + name);
    }
    this->HasBeams = this->HasBeams || parser.Part().HasBeams;
    this->HasSlices = this->HasSlices || parser.Part().HasSlices;
    return this->Models.emplace(name, std::move(parser.Part())).first->second;
  }

  /// The object with its components, moved by the transforms around it, the inner one first.
  void AddObject(const ThreeMfReference& reference, const std::string& from,
    std::vector<ThreeMfTransform> transforms, int depth)
  {
    const std::string key = KeyOf(reference, from);
    ThreeMfPart& part = this->PartAt(key);
    const auto found = part.Objects.find(reference.Object);
    constexpr int deepest = 64;
    if (found == part.Objects.end() || depth > deepest)
    {
      Reject(this->Path,
        depth > deepest ? "its components contain each other"
                        : "an item or component names the object '" +
            reference.Object.substr(0, 40) + "', which is not there");
    }
    const ThreeMfObject& object = found->second;
    this->UsedObjects.insert({ key, reference.Object });
    if (object.Type != "model" && object.Type != "surface")
    {
      const bool isSupport = object.Type == "support" || object.Type == "solidsupport";
      ++(isSupport ? this->Supports : this->Others);
      return;
    }
    transforms.insert(transforms.begin(), reference.Transform);
    this->AddMesh(object.Mesh, transforms, part.Factor);
    for (const ThreeMfReference& component : object.Components)
    {
      this->AddObject(component, key, transforms, depth + 1);
    }
  }

  void AddMesh(const FilePart& mesh, const std::vector<ThreeMfTransform>& transforms, double factor)
  {
    this->BytesLeft -= static_cast<double>(
      256 + mesh.Points.size() * sizeof(mesh.Points[0]) + mesh.Corners.size() * sizeof(int));
    if (this->BytesLeft < 0.0)
    {
      Reject(this->Path, "its components repeat objects to more than a gigabyte");
    }
    if (mesh.Points.empty() && mesh.Corners.empty())
    {
      return;
    }
    FilePart placed = mesh;
    for (std::array<double, 3>& point : placed.Points)
    {
      for (const ThreeMfTransform& transform : transforms)
      {
        point = transform.Of(point);
      }
      for (double& coordinate : point)
      {
        coordinate *= factor;
      }
    }
    const auto isMissing = [&placed](std::uint32_t corner)
    { return corner >= placed.Points.size(); };
    if (std::any_of(placed.Corners.begin(), placed.Corners.end(), isMissing))
    {
      Reject(this->Path, "a triangle has a vertex that is not there");
    }
    const auto mirrors = std::count_if(transforms.begin(), transforms.end(),
      [](const ThreeMfTransform& transform) { return transform.Determinant() < 0.0; });
    for (std::size_t i = 0; mirrors % 2 == 1 && i + 2 < placed.Corners.size(); i += 3)
    {
      std::swap(placed.Corners[i + 1], placed.Corners[i + 2]);
    }
    this->Parts.push_back(std::move(placed));
  }

  /// Singular of the words about several objects.
  static std::string OneOf(const std::string& what)
  {
    const std::string many = "that are";
    return what.rfind(many, 0) == 0 ? "that is" + what.substr(many.size()) : what;
  }

  void Warn(std::vector<std::string>& warnings, vtkPolyData* surface) const
  {
    std::int64_t notBuilt = 0;
    for (const auto& [name, part] : this->Models)
    {
      for (const auto& [id, object] : part.Objects)
      {
        const bool hasMesh = !object.Mesh.Corners.empty();
        notBuilt += hasMesh && this->UsedObjects.count({ name, id }) == 0 ? 1 : 0;
      }
    }
    const std::pair<std::int64_t, const char*> lines[] = {
      { notBuilt, "that the build does not use" },
      { this->NotPrintable, "that are marked as not printable" },
      { this->Supports, "of a type for supports" }, { this->Others, "of another type than model" }
    };
    for (const auto& [count, what] : lines)
    {
      const std::string objects = count == 1 ? std::string("object of the input ") + OneOf(what)
                                             : std::string("objects of the input ") + what;
      AddLeftOutOfReader({ "objects", count, objects, {} }, surface);
      if (count > 0)
      {
        warnings.push_back(
          std::to_string(count) + " " + objects + (count == 1 ? " is not read" : " are not read"));
      }
    }
    if (this->HasBeams)
    {
      AddLeftOutOfReader({ "beams", 1, "or more beam lattices of the input", {} }, surface);
      warnings.emplace_back("the beam lattices of the input are not read");
    }
    if (this->HasSlices)
    {
      warnings.emplace_back(
        "the slices of the input, which may be finer than its meshes, are not read");
    }
  }

  const std::string& Path;
  ZipArchive Zip;
  std::map<std::string, ThreeMfPart> Models; // by name of the part
  // part and id of those that the build names
  std::set<std::pair<std::string, std::string>> UsedObjects;
  std::vector<FilePart> Parts;
  double BytesLeft = 0.0; // that objects may take
  std::int64_t NotPrintable = 0;
  std::int64_t Supports = 0; // objects of types that are not printed
  std::int64_t Others = 0;
  bool HasBeams = false;
  bool HasSlices = false;
};
}

vtkSmartPointer<vtkPolyData> ReadThreeMfFile(
  const std::string& path, std::vector<std::string>& warnings)
{
  return ThreeMfReader(path).Run(warnings);
}
}

#endif
