// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FinishLog.h"

#include "Mesh/SurfaceAssembly.h"

namespace bonedecimate
{
EditLog FinishLog(EditLog log, const RunTask& task, const CleanSurface& cleaned,
  const HalfEdgeMesh& mesh, std::uint64_t inputChecksum)
{
  log.InputChecksum = inputChecksum;
  log.Vertices = mesh.NumberOfVertexSlots();
  log.Faces = mesh.NumberOfFaceSlots();
  log.IsSingle = task.Rounding.ToSingle;
  log.MergesPoints = task.Effective.MergePoints;
  const auto write = [&](VertexId vertex, Vector3& position)
  { position = OutputPosition(task.Input, cleaned, vertex, position, task.Rounding); };
  for (LoggedCollapse& collapse : log.Collapses)
  {
    write(collapse.KeptVertex, collapse.Position);
  }
  for (LoggedPatch& patch : log.Patches)
  {
    for (LoggedPatch::Vertex& vertex : patch.Vertices)
    {
      write(vertex.Id, vertex.Position);
    }
  }
  return log;
}
}
