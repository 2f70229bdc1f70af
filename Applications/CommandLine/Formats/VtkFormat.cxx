// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileChecks.h"
#include "FileFrame.h"
#include "Formats/SurfaceFormat.h"
#include "LineReader.h"
#include "VtkReadersAndWriters.h"

#include "vtkNew.h"
#include "vtkPolyDataReader.h"
#include "vtkPolyDataWriter.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace bonedecimate
{
namespace
{
/// The text of a file that VTK's reader does not take: with a byte-order mark, or with line ends of CR alone. Empty: it takes it.
std::string NormalizedText(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  const std::string mark = "\xEF\xBB\xBF";
  const bool hasMark = text.rfind(mark, 0) == 0;
  const std::size_t lineEnd = text.find_first_of("\r\n");
  const bool hasOnlyReturns =
    lineEnd != std::string::npos && text[lineEnd] == '\r' && text.compare(lineEnd, 2, "\r\n") != 0;
  if (!hasMark && !hasOnlyReturns)
  {
    return {};
  }
  text.erase(0, hasMark ? mark.size() : 0);
  LineReader lines(path);
  for (int i = 0; i < 3; ++i) // version, title, ASCII or BINARY
  {
    lines.Next();
  }
  const bool isText = Trimmed(lines.GetLine()).substr(0, 1).find_first_of("aA") == 0;
  if (isText)
  {
    std::replace(text.begin(), text.end(), '\r', '\n');
  }
  return text;
}

vtkSmartPointer<vtkPolyData> ReadVtk(const std::string& path, std::vector<std::string>&)
{
  CoordinateCollector textPoints;
  CheckVtkFile(path, textPoints);
  const vtkNew<vtkPolyDataReader> reader;
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  const std::string text = NormalizedText(path);
  if (!text.empty())
  {
    reader->ReadFromInputStringOn();
    reader->SetBinaryInputString(text.data(), static_cast<int>(text.size()));
  }
  const vtkSmartPointer<vtkPolyData> surface = ReadWith(reader.Get(), path, textPoints);
  const char* const title = reader->GetHeader();
  SetFrame(title != nullptr ? FrameIn(title) : std::string(), surface);
  return surface;
}

void WriteVtk(vtkPolyData* surface, const std::string& path)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetFileTypeToBinary();
  const std::string frame = FrameOf(surface);
  if (!frame.empty())
  {
    writer->SetHeader(FrameLine(frame).c_str());
  }
  WriteWith(writer.Get(), surface, path);
}

SurfaceFormat VtkRow()
{
  SurfaceFormat format = { "vtk", true, true, true, ReadVtk, WriteVtk };
  format.Check = CheckVtkFile;
  return format;
}
}

extern const SurfaceFormat VtkFormat;
const SurfaceFormat VtkFormat = VtkRow();
}
