// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Meshes of the default scene, placed by its nodes. Files of WriteGlb.cxx come back in mm, as they
/// were written.
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include "FileChecks.h"
#include "FileParts.h"
#include "FileUnit.h"
#include "GlbFiles.h"
#include "GltfDocument.h"
#include "GltfScene.h"

#include "vtkPointData.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace bonedecimate
{
namespace
{
using Json = GltfDocument::Json;

/// Extensions that change no position; names that begin so.
const std::string_view HarmlessExtensions[] = { "KHR_materials_", "KHR_texture_", "EXT_texture_",
  "MSFT_texture_", "KHR_lights_", "EXT_lights_", "KHR_xmp", "KHR_animation_pointer",
  "KHR_node_visibility", QuantizationExtension, MeshoptExtension, KhronosMeshoptExtension };

constexpr const char* DracoExtension = "KHR_draco_mesh_compression";

/// From linear to sRGB: the inverse of the writer's.
double ByteOf(double linear)
{
  const double value =
    linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return std::round(255.0 * std::clamp(value, 0.0, 1.0));
}

/// Three indices for each triangle of a list, strip or fan.
std::vector<std::uint32_t> TriangleList(const std::vector<std::uint32_t>& corners, int mode)
{
  constexpr int strip = 5;
  constexpr int fan = 6;
  std::vector<std::uint32_t> list;
  if (mode != strip && mode != fan)
  {
    list.assign(corners.begin(), corners.end() - static_cast<std::ptrdiff_t>(corners.size() % 3));
    return list;
  }
  for (std::size_t i = 0; i + 2 < corners.size(); ++i)
  {
    const std::size_t turned = mode == strip ? i % 2 : 0;
    list.push_back(corners[mode == fan ? 0 : i]);
    list.push_back(corners[i + 1 + turned]);
    list.push_back(corners[i + 2 - turned]);
  }
  return list;
}

/// The points that the corners name, in their order; the corners are numbered anew.
std::vector<std::uint32_t> UsedPoints(std::vector<std::uint32_t>& corners)
{
  std::vector<std::uint32_t> used = corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (!used.empty() && used.back() + std::size_t(1) != used.size())
  {
    for (std::uint32_t& corner : corners)
    {
      corner = static_cast<std::uint32_t>(
        std::lower_bound(used.begin(), used.end(), corner) - used.begin());
    }
  }
  return used;
}

class GlbReader
{
public:
  explicit GlbReader(const std::string& path)
    : Document(path)
    , Path(path)
  {
  }

  vtkSmartPointer<vtkPolyData> Read(std::vector<std::string>& warnings)
  {
    try
    {
      this->RequireKnown();
      this->Scene = ReadScene(this->Document);
      for (const GltfInstance& instance : this->Scene.Instances)
      {
        this->AddInstance(instance);
      }
    }
    catch (const Json::exception& problem)
    {
      Reject(this->Path, PrintableText(std::string("its JSON is damaged: ") + problem.what()));
    }
    this->Warn(warnings);
    const vtkSmartPointer<vtkPolyData> surface = JoinParts(this->Parts);
    ListLeftOut(this->Scene, this->NoTriangles, surface);
    SetFileUnit(this->Scene.IsInMillimeters ? "mm" : "m", surface);
    return surface;
  }

private:
  void RequireKnown() const
  {
    const Json& root = this->Document.Root();
    const std::string version = root.at("asset").at("version").get<std::string>();
    if (version.rfind("2.", 0) != 0)
    {
      this->Document.Fail("it is glTF of version " + PrintableText(version.substr(0, 20)) +
        "; version 2 is read, to which most programs convert");
    }
    const Json none = Json::array();
    for (const Json& extension :
      root.contains("extensionsRequired") ? root.at("extensionsRequired") : none)
    {
      const auto& name = extension.get_ref<const std::string&>();
      const bool isKnown = std::any_of(std::begin(HarmlessExtensions), std::end(HarmlessExtensions),
        [&name](std::string_view start) { return name.rfind(start, 0) == 0; });
      if (name == DracoExtension)
      {
        this->FailOfDraco();
      }
      if (!isKnown)
      {
        this->Document.Fail("it requires the extension '" + PrintableText(name.substr(0, 100)) +
          "', which is not read");
      }
    }
  }

  [[noreturn]] void FailOfDraco() const
  {
    this->Document.Fail("it is compressed by Draco (KHR_draco_mesh_compression), which is not "
                        "read; save it without compression or with EXT_meshopt_compression");
  }

  /// @param owner A node or a mesh.
  void RequireNoWeights(const Json& owner) const
  {
    const Json none = Json::array();
    for (const Json& weight : owner.contains("weights") ? owner.at("weights") : none)
    {
      if (weight.get<double>() != 0.0)
      {
        this->Document.Fail("a mesh is changed by morph targets, which are not read; a program "
                            "that applies them and saves the result helps");
      }
    }
  }

  void AddInstance(const GltfInstance& instance)
  {
    const Json& mesh = this->Document.EntryOf("meshes", instance.Node->at("mesh"));
    this->RequireNoWeights(*instance.Node);
    this->RequireNoWeights(mesh);
    for (const Json& primitive : mesh.at("primitives"))
    {
      constexpr std::size_t bytesOfPrimitive = 256;
      this->Document.Claim(bytesOfPrimitive);
      this->AddPrimitive(primitive, instance);
    }
  }

  void AddPrimitive(const Json& primitive, const GltfInstance& instance)
  {
    const int mode = primitive.value("mode", 4);
    if (mode >= 0 && mode < 4)
    {
      ++this->NoTriangles;
      return;
    }
    if (mode < 0 || mode > 6)
    {
      this->Document.Fail("a mesh has primitives of the unknown mode " + std::to_string(mode));
    }
    this->HasMorphs = this->HasMorphs || primitive.contains("targets");
    const Json& attributes = primitive.at("attributes");
    if (!attributes.contains("POSITION"))
    {
      ++this->NoTriangles;
      return;
    }
    this->RequireData(primitive, attributes.at("POSITION"));
    const GltfNumbers& positions = this->Document.NumbersOf(attributes.at("POSITION"));
    std::vector<std::uint32_t> corners = this->CornersOf(primitive, positions.Count, mode);
    if (positions.Components != 3 ||
      std::any_of(corners.begin(), corners.end(),
        [&positions](std::uint32_t corner) { return corner >= positions.Count; }))
    {
      this->Document.Fail(positions.Components != 3 ? "a position is not three numbers"
                                                    : "a triangle has a vertex that is not there");
    }
    FilePart part;
    const std::vector<std::uint32_t> used = UsedPoints(corners);
    this->Document.Claim(
      corners.size() * sizeof(corners[0]) + used.size() * sizeof(part.Points[0]));
    part.Corners = std::move(corners);
    this->TransformPoints(positions, used, instance.Transform, part);
    this->AddArrays(attributes, used, instance.Transform, part);
    this->ReadLabel(*instance.Node, primitive, part);
    this->Parts.push_back(std::move(part));
  }

  /// Draco's primitives may have the same data uncompressed.
  void RequireData(const Json& primitive, const Json& position) const
  {
    const bool isDraco =
      primitive.contains("extensions") && primitive.at("extensions").contains(DracoExtension);
    if (isDraco && !this->Document.EntryOf("accessors", position).contains("bufferView"))
    {
      this->FailOfDraco();
    }
  }

  std::vector<std::uint32_t> CornersOf(const Json& primitive, std::size_t points, int mode)
  {
    if (primitive.contains("indices"))
    {
      return TriangleList(this->Document.IndicesOf(primitive.at("indices")), mode);
    }
    this->Document.Claim(points * sizeof(std::uint32_t));
    std::vector<std::uint32_t> corners(std::min<std::size_t>(points, UINT32_MAX));
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      corners[i] = static_cast<std::uint32_t>(i);
    }
    return TriangleList(corners, mode);
  }

  static void TransformPoints(const GltfNumbers& positions, const std::vector<std::uint32_t>& used,
    const GltfTransform& transform, FilePart& part)
  {
    const bool isIdentity = transform.IsIdentity();
    part.Points.reserve(used.size());
    for (const std::uint32_t point : used)
    {
      const double* const p = positions.Values.data() + 3 * std::size_t(point);
      const std::array<double, 3> position = { p[0], p[1], p[2] };
      part.Points.push_back(isIdentity ? position : transform.Of(position));
    }
    for (std::size_t i = 0; transform.Determinant() < 0.0 && i + 2 < part.Corners.size(); i += 3)
    {
      std::swap(part.Corners[i + 1], part.Corners[i + 2]);
    }
  }

  void AddArrays(const Json& attributes, const std::vector<std::uint32_t>& used,
    const GltfTransform& transform, FilePart& part)
  {
    for (const auto& [name, accessor] : attributes.items())
    {
      const bool isOwn = name.rfind('_', 0) == 0;
      if (name == "POSITION")
      {
        continue;
      }
      if (!isOwn && name != "NORMAL" && name != "TEXCOORD_0" && name != "COLOR_0")
      {
        this->LeftOut.insert(PrintableText(name));
        continue;
      }
      const GltfNumbers& numbers = this->Document.NumbersOf(accessor);
      if (!used.empty() && used.back() >= numbers.Count)
      {
        this->Document.Fail(
          "the attribute " + PrintableText(name) + " has fewer values than points");
      }
      this->Document.Claim(used.size() * numbers.Components * sizeof(double));
      PartArray array;
      array.Components = static_cast<int>(numbers.Components);
      array.Type = VTK_FLOAT;
      for (const std::uint32_t point : used)
      {
        const auto first = numbers.Values.begin() +
          static_cast<std::ptrdiff_t>(std::size_t(point) * numbers.Components);
        array.Values.insert(
          array.Values.end(), first, first + static_cast<std::ptrdiff_t>(numbers.Components));
      }
      const std::string ofArray = Converted(name, transform, array);
      part.Arrays[ofArray] = std::move(array);
    }
  }

  /// As arrays of other formats have it: colors in sRGB, texture coordinates from the lower left.
  /// @return The name of the array.
  static std::string Converted(
    const std::string& name, const GltfTransform& transform, PartArray& array)
  {
    std::vector<double>& values = array.Values;
    const auto components = static_cast<std::size_t>(array.Components);
    for (std::size_t i = 0; i + components <= values.size(); i += components)
    {
      if (name == "NORMAL" && components == 3)
      {
        const std::array<double, 3> normal =
          transform.OfNormal({ values[i], values[i + 1], values[i + 2] });
        std::copy(normal.begin(), normal.end(), values.begin() + static_cast<std::ptrdiff_t>(i));
      }
      else if (name == "TEXCOORD_0" && components == 2)
      {
        values[i + 1] = 1.0 - values[i + 1];
      }
      for (std::size_t k = 0; name == "COLOR_0" && k < components; ++k)
      {
        values[i + k] =
          k == 3 ? std::round(255.0 * std::clamp(values[i + k], 0.0, 1.0)) : ByteOf(values[i + k]);
      }
    }
    array.Type = name == "COLOR_0" ? VTK_UNSIGNED_CHAR : VTK_FLOAT;
    return name == "NORMAL"  ? "Normals"
      : name == "TEXCOORD_0" ? "TCoords"
      : name == "COLOR_0"    ? (components == 4 ? "RGBA" : "RGB")
                             : name;
  }

  void ReadLabel(const Json& node, const Json& primitive, FilePart& part) const
  {
    if (!this->Scene.IsInMillimeters || !node.contains("extras") ||
      !node.at("extras").contains("label"))
    {
      return;
    }
    NamedLabel label;
    label.Value = node.at("extras").at("label").get<std::int64_t>();
    label.Name = node.value("name", std::string());
    const Json& color = this->Document.EntryOf("materials", primitive.at("material"))
                          .at("pbrMetallicRoughness")
                          .at("baseColorFactor");
    const auto channel = [&color](std::size_t i)
    { return static_cast<unsigned char>(ByteOf(color.at(i).get<double>())); };
    label.Color = LabelColor{ channel(0), channel(1), channel(2) };
    part.Label = label;
  }

  void Warn(std::vector<std::string>& warnings)
  {
    warnings.insert(warnings.end(), this->Scene.Warnings.begin(), this->Scene.Warnings.end());
    if (this->NoTriangles > 0)
    {
      warnings.push_back(std::to_string(this->NoTriangles) +
        (this->NoTriangles == 1 ? " primitive of points or lines is not read"
                                : " primitives of points or lines are not read"));
    }
    if (this->HasMorphs)
    {
      warnings.emplace_back("the morph targets of the input, which have no weight, are not read");
    }
    std::string names;
    for (const std::string& name : this->LeftOut)
    {
      names += (names.empty() ? "" : ", ") + name.substr(0, 40);
    }
    for (const std::string& name : ArraysOfSomeParts(this->Parts))
    {
      names += (names.empty() ? "" : ", ") + (name + " (which some meshes lack)").substr(0, 80);
    }
    if (!names.empty())
    {
      warnings.push_back("attributes of the input that are not kept: " + names.substr(0, 400));
    }
    if (this->Document.ExtraBytes() > 0)
    {
      warnings.push_back(std::to_string(this->Document.ExtraBytes()) +
        " bytes behind the contents of the file are not read");
    }
  }

  GltfDocument Document;
  const std::string& Path;
  GltfScene Scene;
  std::vector<FilePart> Parts;
  std::set<std::string> LeftOut; // attributes that are not kept
  std::int64_t NoTriangles = 0;  // primitives of points and lines
  bool HasMorphs = false;
};
}

vtkSmartPointer<vtkPolyData> ReadGlbFile(
  const std::string& path, std::vector<std::string>& warnings)
{
  return GlbReader(path).Read(warnings);
}
}

#endif
