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
/// Cell numbers have 21 bits per axis; positions beyond belong to the outermost cell.
constexpr std::int32_t Farthest = (1 << 20) - 1;
/// Width of a cell, in faces. Faces grow: in smaller cells they would soon be in too many, and
/// larger cells have parts of too many workers in them.
constexpr double FacesOfSide = 2.0;
/// Distance from the surface within which empty cells get an interval, in sides of a cell.
constexpr double Margin = 0.25;
/// Slack for rounding, in sides of a cell.
constexpr double Rounding = 1e-6;

FaceGrid::CellKey KeyOf(std::int32_t x, std::int32_t y, std::int32_t z)
{
  const auto part = [](std::int64_t i) { return static_cast<FaceGrid::CellKey>(i + Farthest + 1); };
  return part(x) << 42U | part(y) << 21U | part(z);
}

std::int32_t Floor(double coordinate) // in sides of a cell
{
  return static_cast<std::int32_t>(std::floor(std::clamp<double>(coordinate, -Farthest, Farthest)));
}

/// The cells that a triangle reaches, column by column along the axis in which its normal is
/// longest.
class Columns
{
public:
  /// @param p Corners in sides of a cell.  @param reach Reach in sides of a cell.
  Columns(const TriangleCorners& p, double reach)
    : Normal((p[1] - p[0]).cross(p[2] - p[0]))
  {
    this->Low = p[0].cwiseMin(p[1]).cwiseMin(p[2]).array() - reach;
    this->High = p[0].cwiseMax(p[1]).cwiseMax(p[2]).array() + reach;
    this->Normal.cwiseAbs().maxCoeff(&this->Axis);
    const double steepest = this->Normal[this->Axis];
    const double farthest =
      std::max(this->Low.cwiseAbs().maxCoeff(), this->High.cwiseAbs().maxCoeff());
    this->HasPlane = steepest != 0.0 && farthest < Farthest;
    if (this->HasPlane)
    {
      this->Normal /= steepest;
      const Vector3 heights(
        Dot(this->Normal, p[0]), Dot(this->Normal, p[1]), Dot(this->Normal, p[2]));
      // Within half the width of a column, 1, the plane rises by no more than that.
      const double slack =
        reach * this->Normal.norm() + 0.5 * (this->Normal.cwiseAbs().sum() - 1.0) + Rounding;
      this->MinHeight = heights.minCoeff() - slack;
      this->MaxHeight = heights.maxCoeff() + slack;
    }
  }

  /// First and last cell of the column whose middle lies at u and v of the two other axes.
  std::array<std::int32_t, 2> Ends(Eigen::Index u, double atU, Eigen::Index v, double atV) const
  {
    double low = this->Low[this->Axis];
    double high = this->High[this->Axis];
    if (this->HasPlane)
    {
      const double height = this->Normal[u] * atU + this->Normal[v] * atV;
      low = std::max(low, this->MinHeight - height);
      high = std::min(high, this->MaxHeight - height);
    }
    return { Floor(low), low <= high ? Floor(high) : Floor(low) - 1 };
  }

  Eigen::Index Axis = 0;
  Vector3 Low, High; // in sides of a cell

private:
  Vector3 Normal;
  bool HasPlane = false;
  double MinHeight = 0.0, MaxHeight = 0.0; // heights along the axis
};
}

FaceGrid::Nodes::Nodes()
  : Chunks(std::make_unique<std::unique_ptr<Node[]>[]>(MaxChunks))
{
}

//------------------------------------------------------------------------------
Index FaceGrid::Nodes::Allocate()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->FirstFree != None)
  {
    const Index node = this->FirstFree;
    this->FirstFree = (*this)[node].Next;
    return node;
  }
  if (this->Count % NodesPerChunk == 0)
  {
    this->Chunks[this->Count / NodesPerChunk] = std::make_unique<Node[]>(NodesPerChunk);
  }
  return this->Count++;
}

//------------------------------------------------------------------------------
void FaceGrid::Nodes::Release(Index node)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  (*this)[node].Next = this->FirstFree;
  this->FirstFree = node;
}

//------------------------------------------------------------------------------
FaceGrid::FaceGrid(const HalfEdgeMesh& mesh, double minCellSize)
  : CellSize(ChooseCellSize(mesh, minCellSize))
  , LastVertex(mesh.NumberOfVertexSlots() - 1)
  , Cells(1024)
{
  std::vector<CellKey> cells;
  for (Index face = 0; face < mesh.NumberOfFaceSlots(); ++face)
  {
    if (!mesh.IsAlive(face))
    {
      continue;
    }
    const Triangle v = mesh.Corners(face);
    const TriangleCorners corners = CornersOf(mesh, v);
    cells.clear();
    this->AddCells(corners, Margin * this->CellSize, cells);
    for (const CellKey cell : cells)
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
/// A cell is a few mean faces wide, more if some faces are so large that they would fill too many
/// cells.
double FaceGrid::ChooseCellSize(const HalfEdgeMesh& mesh, double minSize)
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
  return FacesOfSide *
    std::max({ minSize, 1.25 * lengths / faces, std::sqrt(areas / faces), 1e-30 });
}

//------------------------------------------------------------------------------
void FaceGrid::AddCells(
  const TriangleCorners& corners, double reach, std::vector<CellKey>& cells) const
{
  const double perSide = 1.0 / this->CellSize;
  TriangleCorners p = { corners[0] * perSide, corners[1] * perSide, corners[2] * perSide };
  // Sorted, so the cells of insertion and removal are the same whatever the order of the corners.
  for (const std::size_t i : { 0U, 1U, 0U })
  {
    if (std::lexicographical_compare(
          p[i + 1].data(), p[i + 1].data() + 3, p[i].data(), p[i].data() + 3))
    {
      std::swap(p[i], p[i + 1]);
    }
  }
  const Columns columns(p, reach * perSide + Rounding);
  const Eigen::Index u = (columns.Axis + 1) % 3;
  const Eigen::Index v = (columns.Axis + 2) % 3;
  std::array<std::int32_t, 3> at;
  for (at[u] = Floor(columns.Low[u]); at[u] <= Floor(columns.High[u]); ++at[u])
  {
    for (at[v] = Floor(columns.Low[v]); at[v] <= Floor(columns.High[v]); ++at[v])
    {
      const std::array<std::int32_t, 2> ends = columns.Ends(u, at[u] + 0.5, v, at[v] + 0.5);
      for (at[columns.Axis] = ends[0]; at[columns.Axis] <= ends[1]; ++at[columns.Axis])
      {
        cells.push_back(KeyOf(at[0], at[1], at[2]));
      }
    }
  }
}

//------------------------------------------------------------------------------
/// The slot of the cell, or the free one for it.
std::size_t FaceGrid::SlotOf(CellKey cell) const
{
  const std::size_t mask = this->Cells.size() - 1;
  std::size_t slot = this->FirstSlotOf(cell);
  while (this->Cells[slot].Key != cell && this->Cells[slot].Key != Free)
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

//------------------------------------------------------------------------------
/// Only a worker whose range is the whole mesh may add one.
FaceGrid::Cell& FaceGrid::FindOrAdd(CellKey cell)
{
  std::size_t slot = this->SlotOf(cell);
  if (this->Cells[slot].Key == Free)
  {
    if (3 * ++this->UsedCells > 2 * this->Cells.size())
    {
      this->Grow();
      slot = this->SlotOf(cell);
    }
    this->Cells[slot].Key = cell;
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
    if (cell.Key != Free)
    {
      Cell& moved = this->Cells[this->SlotOf(cell.Key)];
      moved.Key = cell.Key;
      moved.FirstNode = cell.FirstNode;
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
FaceGrid::CellKey FaceGrid::CellAt(const Vector3& corner) const
{
  const Vector3 p = corner * (1.0 / this->CellSize);
  return KeyOf(Floor(p[0]), Floor(p[1]), Floor(p[2]));
}

//------------------------------------------------------------------------------
bool FaceGrid::OwnsAll(VertexRange range, const std::vector<CellKey>& cells) const
{
  for (const CellKey cell : cells)
  {
    Prefetch(&this->Cells[this->FirstSlotOf(cell)]);
  }
  return std::all_of(
    cells.begin(), cells.end(), [&](CellKey cell) { return this->Owns(range, cell); });
}

//------------------------------------------------------------------------------
/// Safe while the owner extends the interval: neither before nor after does the range of another
/// worker contain it.
bool FaceGrid::Owns(VertexRange range, CellKey key) const
{
  const Cell& cell = this->Cells[this->SlotOf(key)];
  return cell.Key != Free && range.Contains(cell.Low.load(std::memory_order_relaxed)) &&
    range.Contains(cell.High.load(std::memory_order_relaxed));
}

//------------------------------------------------------------------------------
void FaceGrid::AddFaces(
  const std::vector<CellKey>& cells, const FloatBox& box, std::vector<Index>& faces) const
{
  for (const CellKey key : cells)
  {
    for (Index node = this->Cells[this->SlotOf(key)].FirstNode; node != None;
         node = this->NodePool[node].Next)
    {
      if (this->NodePool[node].Box.Meets(box))
      {
        faces.push_back(this->NodePool[node].Face);
      }
    }
  }
}

//------------------------------------------------------------------------------
void FaceGrid::Insert(Index face, const Triangle& vertices, const TriangleCorners& corners,
  const std::vector<CellKey>& cells)
{
  const FloatBox box(corners);
  const auto [low, high] = std::minmax({ vertices[0], vertices[1], vertices[2] });
  for (const CellKey key : cells)
  {
    Cell& cell = this->FindOrAdd(key);
    const Index node = this->NodePool.Allocate();
    this->NodePool[node] = { face, cell.FirstNode, box };
    cell.FirstNode = node;
    cell.Low.store(
      std::min(cell.Low.load(std::memory_order_relaxed), low), std::memory_order_relaxed);
    cell.High.store(
      std::max(cell.High.load(std::memory_order_relaxed), high), std::memory_order_relaxed);
  }
}

//------------------------------------------------------------------------------
void FaceGrid::Remove(Index face, const std::vector<CellKey>& cells)
{
  for (const CellKey key : cells)
  {
    Index* link = &this->Cells[this->SlotOf(key)].FirstNode;
    while (this->NodePool[*link].Face != face)
    {
      link = &this->NodePool[*link].Next;
    }
    const Index node = *link;
    *link = this->NodePool[node].Next;
    this->NodePool.Release(node);
  }
}
}
