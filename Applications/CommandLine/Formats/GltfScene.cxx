// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER

#include "GltfScene.h"

#include "FileChecks.h"
#include "GlbFiles.h"
#include "LeftOutOfReader.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace bonedecimate
{
namespace
{
using Json = GltfDocument::Json;
using Vector = std::array<double, 3>;

/// Columns of four numbers, as glTF has them.
GltfTransform FromColumns(const std::array<double, 16>& m)
{
  GltfTransform transform;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 4; ++column)
    {
      transform.Rows[4 * row + column] = m[4 * column + row];
    }
  }
  return transform;
}

/// Translation x rotation x scale.
GltfTransform FromParts(
  const Vector& translation, const std::array<double, 4>& rotation, const Vector& scale)
{
  auto [x, y, z, w] = rotation;
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  const bool isTurn = std::isfinite(length) && length > 0.0;
  // What is exactly 1 stays so.
  const double factor = isTurn && std::abs(length - 1.0) > 1e-15 ? 1.0 / length : 1.0;
  x *= factor;
  y *= factor;
  z *= factor;
  w *= factor;
  const std::array<double, 9> turn = { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z),
    2 * (x * z + w * y), 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y) };
  GltfTransform transform;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      transform.Rows[4 * row + column] = turn[3 * row + column] * scale[column];
    }
    transform.Rows[4 * row + 3] = translation[row];
  }
  return transform;
}

template <typename Numbers>
Numbers NumbersIn(const Json& node, const char* name, const Numbers& otherwise)
{
  return node.contains(name) ? node.at(name).get<Numbers>() : otherwise;
}

GltfTransform TransformOf(const Json& node)
{
  if (node.contains("matrix"))
  {
    return FromColumns(node.at("matrix").get<std::array<double, 16>>());
  }
  return FromParts(NumbersIn(node, "translation", Vector{ 0.0, 0.0, 0.0 }),
    NumbersIn(node, "rotation", std::array<double, 4>{ 0.0, 0.0, 0.0, 1.0 }),
    NumbersIn(node, "scale", Vector{ 1.0, 1.0, 1.0 }));
}

/// The node that GlbFiles.h describes: below it the surface is in millimeters and in the frame of
/// its input.
bool IsFrameOfProgram(const Json& node)
{
  const bool saysUnit = node.contains("extras") && node.at("extras").is_object() &&
    node.at("extras").value("unit", Json()) == "mm";
  return saysUnit && node.contains("matrix") &&
    node.at("matrix").get<std::array<double, 16>>() == FrameMatrix;
}

/// Goes through the nodes without recursion, each one once.
class SceneReader
{
public:
  explicit SceneReader(const GltfDocument& document)
    : Document(document)
  {
  }

  GltfScene Run()
  {
    const Json& roots = this->Roots();
    this->Scene.IsInMillimeters =
      roots.size() == 1 && IsFrameOfProgram(this->Document.EntryOf("nodes", roots.at(0)));
    this->Push(roots, {});
    while (!this->Waiting.empty())
    {
      const auto [index, around] = this->Waiting.back();
      this->Waiting.pop_back();
      this->Visit(index, around);
    }
    this->Warn();
    return std::move(this->Scene);
  }

private:
  const Json& Roots()
  {
    const Json& root = this->Document.Root();
    if (root.contains("scenes") && !root.at("scenes").empty())
    {
      const Json first = std::size_t(0);
      const Json& scene =
        this->Document.EntryOf("scenes", root.contains("scene") ? root.at("scene") : first);
      this->NoNodes = Json::array();
      return scene.contains("nodes") ? scene.at("nodes") : this->NoNodes;
    }
    return this->ParentlessNodes();
  }

  /// Nodes without a parent: the roots of a document without a scene.
  const Json& ParentlessNodes()
  {
    this->NoNodes = Json::array();
    std::set<std::size_t> children;
    const Json none = Json::array();
    const Json& nodes =
      this->Document.Root().contains("nodes") ? this->Document.Root().at("nodes") : none;
    for (const Json& node : nodes)
    {
      for (const Json& child : node.contains("children") ? node.at("children") : none)
      {
        children.insert(child.get<std::size_t>());
      }
    }
    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
      if (children.count(i) == 0)
      {
        this->NoNodes.push_back(i);
      }
    }
    return this->NoNodes;
  }

  /// The last one first, so that they are visited in the order of the file.
  void Push(const Json& indices, const GltfTransform& around)
  {
    for (std::size_t i = indices.size(); i-- > 0;)
    {
      const Json& index = indices.at(i);
      this->Document.EntryOf("nodes", index);
      if (!this->Seen.insert(index.get<std::size_t>()).second)
      {
        this->Document.Fail("a node has two parents, so that its nodes are no tree");
      }
      this->Waiting.emplace_back(&index, around);
    }
  }

  void Visit(const Json* index, const GltfTransform& around)
  {
    const Json& node = this->Document.EntryOf("nodes", *index);
    const Json none = Json::object();
    const Json& extensions = node.contains("extensions") ? node.at("extensions") : none;
    const auto visibility = extensions.find("KHR_node_visibility");
    if (visibility != extensions.end() && !visibility->value("visible", true))
    {
      ++this->Hidden;
      return;
    }
    const bool isFrame = this->Scene.IsInMillimeters && this->Seen.size() == 1;
    const GltfTransform transform = isFrame ? around : around.After(TransformOf(node));
    if (node.contains("mesh"))
    {
      if (extensions.contains("EXT_mesh_gpu_instancing"))
      {
        this->Document.Fail(
          "a node repeats its mesh by EXT_mesh_gpu_instancing, which is not read");
      }
      if (node.contains("skin"))
      {
        this->Document.Fail("a mesh is bent by a skeleton (skin), which is not read; a program "
                            "that applies the pose and saves it without a skeleton helps");
      }
      this->UsedMeshes.insert(node.at("mesh").get<std::size_t>());
      this->Scene.Instances.push_back({ &node, transform });
    }
    if (node.contains("children"))
    {
      this->Push(node.at("children"), transform);
    }
  }

  void Warn()
  {
    const Json& root = this->Document.Root();
    const std::size_t meshes = root.contains("meshes") ? root.at("meshes").size() : 0;
    const std::size_t unused = meshes - std::min(meshes, this->UsedMeshes.size());
    this->Scene.HiddenNodes = this->Hidden;
    this->Scene.UnusedMeshes = static_cast<std::int64_t>(this->Hidden == 0 ? unused : 0);
    if (this->Hidden > 0)
    {
      this->Scene.Warnings.push_back(std::to_string(this->Hidden) +
        (this->Hidden == 1 ? " node of the input that is" : " nodes of the input that are") +
        " marked as not visible and what is below are not read");
    }
    if (unused > 0 && this->Hidden == 0)
    {
      this->Scene.Warnings.push_back(std::to_string(unused) +
        (unused == 1 ? " mesh of the input that the scene does not use is not read"
                     : " meshes of the input that the scene does not use are not read"));
    }
    if (root.contains("animations") && !root.at("animations").empty())
    {
      this->Scene.Warnings.emplace_back("the animations of the input are not read");
    }
  }

  const GltfDocument& Document;
  GltfScene Scene;
  Json NoNodes;
  std::vector<std::pair<const Json*, GltfTransform>> Waiting;
  std::set<std::size_t> Seen;
  std::set<std::size_t> UsedMeshes;
  std::size_t Hidden = 0;
};
}

GltfTransform GltfTransform::After(const GltfTransform& inner) const
{
  GltfTransform both;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 4; ++column)
    {
      double sum = column == 3 ? this->Rows[4 * row + 3] : 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        sum += this->Rows[4 * row + k] * inner.Rows[4 * k + column];
      }
      both.Rows[4 * row + column] = sum;
    }
  }
  return both;
}

std::array<double, 3> GltfTransform::Of(const std::array<double, 3>& point) const
{
  std::array<double, 3> moved = {};
  for (std::size_t row = 0; row < 3; ++row)
  {
    const double* const m = this->Rows.data() + 4 * row;
    moved[row] = m[0] * point[0] + m[1] * point[1] + m[2] * point[2] + m[3];
  }
  return moved;
}

double GltfTransform::Determinant() const
{
  const std::array<double, 12>& m = this->Rows;
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
    m[2] * (m[4] * m[9] - m[5] * m[8]);
}

std::array<double, 3> GltfTransform::OfNormal(const std::array<double, 3>& normal) const
{
  const std::array<double, 12>& m = this->Rows;
  const double sign = this->Determinant() < 0.0 ? -1.0 : 1.0;
  std::array<double, 3> turned = {};
  double square = 0.0;
  for (std::size_t row = 0; row < 3; ++row)
  {
    const std::size_t a = 4 * ((row + 1) % 3);
    const std::size_t b = 4 * ((row + 2) % 3);
    for (std::size_t column = 0; column < 3; ++column)
    {
      const std::size_t c = (column + 1) % 3;
      const std::size_t d = (column + 2) % 3;
      turned[row] += sign * (m[a + c] * m[b + d] - m[a + d] * m[b + c]) * normal[column];
    }
    square += turned[row] * turned[row];
  }
  const double length = std::sqrt(square);
  for (double& coordinate : turned)
  {
    coordinate = length > 0.0 ? coordinate / length : coordinate;
  }
  return turned;
}

GltfScene ReadScene(const GltfDocument& document)
{
  return SceneReader(document).Run();
}

//------------------------------------------------------------------------------
void ListLeftOut(const GltfScene& scene, std::int64_t primitives, vtkPolyData* surface)
{
  const auto add = [surface](
                     std::int64_t count, const char* kind, const char* one, const char* several) {
    AddLeftOutOfReader({ kind, count, count == 1 ? one : several, {} }, surface);
  };
  add(scene.HiddenNodes, "objects", "node that is not visible", "nodes that are not visible");
  add(scene.UnusedMeshes, "objects", "mesh that the scene does not use",
    "meshes that the scene does not use");
  add(primitives, "lines", "primitive of points or lines", "primitives of points or lines");
}
}

#endif
