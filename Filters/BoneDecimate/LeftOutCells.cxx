// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LeftOutCells.h"

#include "CellVisits.h"
#include "LeftOutOfReader.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <string>
#include <utility>

namespace bonedecimate
{
namespace
{
/// The noun in the number of the count.
std::string Noun(std::int64_t count, const char* one, const char* several)
{
  return count == 1 ? one : several;
}

/// Cells of one kind, those with wrong ids apart.
struct Curves
{
  std::vector<std::array<Vector3, 3>> Shapes;
  std::int64_t Count = 0;
  vtkIdType First = -1;

  /// Each segment of a line, or each point.
  void Add(vtkIdType cell, vtkIdType npts, const vtkIdType* ids, bool isLine,
    const std::vector<Vector3>& points)
  {
    this->First = this->Count++ == 0 ? cell : this->First;
    for (vtkIdType i = 0; i < npts; ++i)
    {
      const Vector3& p = points[static_cast<std::size_t>(ids[i])];
      const Vector3& next =
        isLine && i + 1 < npts ? points[static_cast<std::size_t>(ids[i + 1])] : p;
      this->Shapes.push_back({ p, next, next });
    }
  }

  void AddTo(
    std::vector<LeftOutShape>& found, const char* kind, const char* one, const char* several)
  {
    if (this->Count > 0)
    {
      found.push_back({ { kind, this->Count, Noun(this->Count, one, several),
                          "cell " + std::to_string(this->First) },
        std::move(this->Shapes) });
    }
  }
};

/// Lines and vertices.
void AddCurves(
  vtkPolyData* input, const std::vector<Vector3>& points, std::vector<LeftOutShape>& found)
{
  Curves lines;
  Curves vertices;
  Curves wrong;
  const auto add =
    [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids, bool isLine, Curves& curves)
  {
    const bool isWrong = HasWrongId(npts, ids, input->GetNumberOfPoints());
    (isWrong ? wrong : curves).Add(cell, isWrong ? 0 : npts, ids, isLine, points);
  };
  VisitCells(input->GetLines(), input->GetNumberOfVerts(),
    [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids)
    { add(cell, npts, ids, true, lines); });
  VisitCells(input->GetVerts(), 0,
    [&](vtkIdType cell, vtkIdType npts, const vtkIdType* ids)
    { add(cell, npts, ids, false, vertices); });
  lines.AddTo(found, "lines", "line", "lines");
  vertices.AddTo(found, "vertices", "vertex cell", "vertex cells");
  wrong.AddTo(found, "lines", "line or vertex that names points that are not there",
    "lines and vertices that name points that are not there");
}
}

std::vector<LeftOutShape> FindLeftOut(
  vtkPolyData* input, const std::vector<Vector3>& points, const TriangulatedCells& cells)
{
  std::vector<LeftOutShape> found;
  if (cells.LeftOut > 0)
  {
    found.push_back({ { "polygons", cells.LeftOut,
                        Noun(cells.LeftOut, "polygon of fewer than three different corners",
                          "polygons of fewer than three different corners"),
                        "cell " + std::to_string(cells.FirstLeftOut) },
      cells.ShapesLeftOut });
  }
  AddCurves(input, points, found);
  for (LeftOut& entry : LeftOutOfReader(input))
  {
    found.push_back({ std::move(entry), {} });
  }
  return found;
}
}
