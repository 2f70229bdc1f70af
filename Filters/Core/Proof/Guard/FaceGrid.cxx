// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceGrid.h"

#include "Base/Prefetch.h"

#include <algorithm>
#include <cmath>

namespace bonedecimate
{
namespace
{
/// Cells along an axis are numbered by 21 bits; what lies beyond counts to the last.
constexpr std::int32_t Farthest = (1 << 20) - 1;
/// How many faces a cell is wide. Faces grow: in smaller cells they would soon be in too many,
/// larger ones have parts of too many workers in them.
constexpr double FacesOfSide = 2.0;
/// How far from the surface empty cells get an interval, in sides of a cell.
constexpr double Margin = 0.25;
/// Slack for the rounding of quotients by the side of a cell, in sides of a cell.
constexpr double Rounding = 1e-6;

FaceGrid::Key NameOf(std::int32_t x, std::int32_t y, std::int32_t z)
{
  const auto part = [](std::int64_t i) { return static_cast<FaceGrid::Key>(i + Farthest + 1); };
  return part(x) << 42U | part(y) << 21U | part(z);
}

std::int32_t Floor(double coordinate) // in sides of a cell
{
  return static_cast<std::int32_t>(std::floor(std::clamp<double>(coordinate, -Farthest, Farthest)));
}

/// The cells that a triangle reaches into, column by column of the axis along which its plane is
/// steepest.
class Columns
{
public:
  /// @param p Corners in sides of a cell.  @param reach Reach in sides of a cell.
  Columns(const TriangleCorners& p, double reach)
    : Normal((p[1] - p[0]).cross(p[2] - p[0]))
  {
    this->Low = p[0].cwiseMin(p[1]).cwiseMin(p[2]).array() - reach;
    this->High = p[0].cwiseMax(p[1]).cwiseMax(p[2]).array() + reach;
    this->Normal.cwiseAbs().maxCoeff(&this->Along);
    const double steepest = this->Normal[this->Along];
    const double farthest =
      std::max(this->Low.cwiseAbs().maxCoeff(), this->High.cwiseAbs().maxCoeff());
    this->HasPlane = steepest != 0.0 && farthest < Farthest;
    if (this->HasPlane)
    {
      this->Normal /= steepest;
      const Vector3 heights(
        Dot(this->Normal, p[0]), Dot(this->Normal, p[1]), Dot(this->Normal, p[2]));
      // A cell's columns are one wide; the plane rises by no more than that across them.
      const double slack =
        reach * this->Normal.norm() + 0.5 * (this->Normal.cwiseAbs().sum() - 1.0) + Rounding;
      this->Least = heights.minCoeff() - slack;
      this->Most = heights.maxCoeff() + slack;
    }
  }

  /// Where the column begins and ends whose middle lies at u and v of the two other axes.
  std::array<std::int32_t, 2> Ends(Eigen::Index u, double atU, Eigen::Index v, double atV) const
  {
    double low = this->Low[this->Along];
    double high = this->High[this->Along];
    if (this->HasPlane)
    {
      const double height = this->Normal[u] * atU + this->Normal[v] * atV;
      low = std::max(low, this->Least - height);
      high = std::min(high, this->Most - height);
    }
    return { Floor(low), low <= high ? Floor(high) : Floor(low) - 1 };
  }

  Eigen::Index Along = 0;
  Vector3 Low, High; // in sides of a cell

private:
  Vector3 Normal;
  bool HasPlane = false;
  double Least = 0.0, Most = 0.0; // heights along the axis
};
}

FaceGrid::Nodes::Nodes()
  : Chunks(std::make_unique<std::unique_ptr<Node[]>[]>(MaxChunks))
{
}

//------------------------------------------------------------------------------
Index FaceGrid::Nodes::Take()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->FirstFree != None)
  {
    const Index node = this->FirstFree;
    this->FirstFree = (*this)[node].Next;
    return node;
  }
  if (this->Count % OfChunk == 0)
  {
    this->Chunks[this->Count / OfChunk] = std::make_unique<Node[]>(OfChunk);
  }
  return this->Count++;
}

//------------------------------------------------------------------------------
void FaceGrid::Nodes::Give(Index node)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  (*this)[node].Next = this->FirstFree;
  this->FirstFree = node;
}

//------------------------------------------------------------------------------
FaceGrid::FaceGrid(const HalfEdgeMesh& mesh, double leastCell)
  : Side(CellFor(mesh, leastCell))
  , LastVertex(mesh.NumberOfVertexSlots() - 1)
  , Cells(1024)
{
  std::vector<Key> cells;
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (!mesh.IsAlive(face))
    {
      continue;
    }
    const Triangle v = mesh.Corners(face);
    const TriangleCorners corners = CornersOf(mesh, v);
    cells.clear();
    this->AddCells(corners, Margin * this->Side, cells);
    for (const Key cell : cells)
    {
      Cell& known = this->FindOrAdd(cell);
      known.Low = std::min({ known.Low.load(), v[0], v[1], v[2] });
      known.High = std::max({ known.High.load(), v[0], v[1], v[2] });
    }
    cells.clear();
    this->AddCells(corners, 0.0, cells);
    this->Insert(face, v, corners, cells);
  }
}

//------------------------------------------------------------------------------
/// Some faces on average, many more where few faces are so large that they would fill too many
/// cells.
double FaceGrid::CellFor(const HalfEdgeMesh& mesh, double least)
{
  double lengths = 0.0; // mm
  double areas = 0.0;   // mm^2
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (!mesh.IsAlive(face))
    {
      continue;
    }
    const TriangleCorners p = CornersOf(mesh, mesh.Corners(face));
    const Vector3 size = p[0].cwiseMax(p[1]).cwiseMax(p[2]) - p[0].cwiseMin(p[1]).cwiseMin(p[2]);
    lengths += size.maxCoeff();
    areas += size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  }
  const double faces = std::max(1, mesh.NumberOfFaces());
  return FacesOfSide * std::max({ least, 1.25 * lengths / faces, std::sqrt(areas / faces), 1e-30 });
}

//------------------------------------------------------------------------------
void FaceGrid::AddCells(const TriangleCorners& corners, double reach, std::vector<Key>& cells) const
{
  const double perSide = 1.0 / this->Side;
  TriangleCorners p = { corners[0] * perSide, corners[1] * perSide, corners[2] * perSide };
  // In whatever order they come: what is inserted has to be found when it is removed.
  for (const std::size_t i : { 0U, 1U, 0U })
  {
    if (std::lexicographical_compare(
          p[i + 1].data(), p[i + 1].data() + 3, p[i].data(), p[i].data() + 3))
    {
      std::swap(p[i], p[i + 1]);
    }
  }
  const Columns columns(p, reach * perSide + Rounding);
  const Eigen::Index u = (columns.Along + 1) % 3;
  const Eigen::Index v = (columns.Along + 2) % 3;
  std::array<std::int32_t, 3> at;
  for (at[u] = Floor(columns.Low[u]); at[u] <= Floor(columns.High[u]); ++at[u])
  {
    for (at[v] = Floor(columns.Low[v]); at[v] <= Floor(columns.High[v]); ++at[v])
    {
      const std::array<std::int32_t, 2> ends = columns.Ends(u, at[u] + 0.5, v, at[v] + 0.5);
      for (at[columns.Along] = ends[0]; at[columns.Along] <= ends[1]; ++at[columns.Along])
      {
        cells.push_back(NameOf(at[0], at[1], at[2]));
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Where the cell is, or where it would be.
std::size_t FaceGrid::SlotOf(Key cell) const
{
  const std::size_t mask = this->Cells.size() - 1;
  std::size_t slot = this->FirstSlotOf(cell);
  while (this->Cells[slot].Name != cell && this->Cells[slot].Name != Free)
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

//------------------------------------------------------------------------------
/// Only a worker whose range is the whole mesh may add one.
FaceGrid::Cell& FaceGrid::FindOrAdd(Key cell)
{
  std::size_t slot = this->SlotOf(cell);
  if (this->Cells[slot].Name == Free)
  {
    if (3 * ++this->Used > 2 * this->Cells.size())
    {
      this->Grow();
      slot = this->SlotOf(cell);
    }
    this->Cells[slot].Name = cell;
  }
  return this->Cells[slot];
}

//------------------------------------------------------------------------------
void FaceGrid::Grow()
{
  std::vector<Cell> old(2 * this->Cells.size());
  old.swap(this->Cells);
  for (const Cell& cell : old)
  {
    if (cell.Name != Free)
    {
      Cell& moved = this->Cells[this->SlotOf(cell.Name)];
      moved.Name = cell.Name;
      moved.First = cell.First;
      moved.Low = cell.Low.load();
      moved.High = cell.High.load();
    }
  }
}

//------------------------------------------------------------------------------
bool FaceGrid::HoldsAll(VertexRange range) const
{
  return range.Contains(0) && range.Contains(this->LastVertex);
}

//------------------------------------------------------------------------------
FaceGrid::Key FaceGrid::CellAt(const Vector3& corner) const
{
  const Vector3 p = corner * (1.0 / this->Side);
  return NameOf(Floor(p[0]), Floor(p[1]), Floor(p[2]));
}

//------------------------------------------------------------------------------
bool FaceGrid::OwnsAll(VertexRange range, const std::vector<Key>& cells) const
{
  for (const Key cell : cells)
  {
    Prefetch(&this->Cells[this->FirstSlotOf(cell)]);
  }
  return std::all_of(cells.begin(), cells.end(), [&](Key cell) { return this->Owns(range, cell); });
}

//------------------------------------------------------------------------------
/// Safe while the owner extends the interval: before and after that, no other worker's range
/// contains it.
bool FaceGrid::Owns(VertexRange range, Key name) const
{
  const Cell& cell = this->Cells[this->SlotOf(name)];
  return cell.Name != Free && range.Contains(cell.Low.load(std::memory_order_relaxed)) &&
    range.Contains(cell.High.load(std::memory_order_relaxed));
}

//------------------------------------------------------------------------------
void FaceGrid::AddFaces(
  const std::vector<Key>& cells, const FloatBox& box, std::vector<Index>& faces) const
{
  for (const Key name : cells)
  {
    for (Index node = this->Cells[this->SlotOf(name)].First; node != None;
         node = this->Entries[node].Next)
    {
      if (this->Entries[node].Box.Meets(box))
      {
        faces.push_back(this->Entries[node].Face);
      }
    }
  }
}

//------------------------------------------------------------------------------
void FaceGrid::Insert(Index face, const Triangle& vertices, const TriangleCorners& corners,
  const std::vector<Key>& cells)
{
  const FloatBox box(corners);
  const auto [low, high] = std::minmax({ vertices[0], vertices[1], vertices[2] });
  for (const Key name : cells)
  {
    Cell& cell = this->FindOrAdd(name);
    const Index node = this->Entries.Take();
    this->Entries[node] = { face, cell.First, box };
    cell.First = node;
    cell.Low.store(
      std::min(cell.Low.load(std::memory_order_relaxed), low), std::memory_order_relaxed);
    cell.High.store(
      std::max(cell.High.load(std::memory_order_relaxed), high), std::memory_order_relaxed);
  }
}

//------------------------------------------------------------------------------
void FaceGrid::Remove(Index face, const std::vector<Key>& cells)
{
  for (const Key name : cells)
  {
    Index* link = &this->Cells[this->SlotOf(name)].First;
    while (this->Entries[*link].Face != face)
    {
      link = &this->Entries[*link].Next;
    }
    const Index node = *link;
    *link = this->Entries[node].Next;
    this->Entries.Give(node);
  }
}
}
