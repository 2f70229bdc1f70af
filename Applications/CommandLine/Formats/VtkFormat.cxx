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

#include <fstream>
#include <iterator>
#include <limits>

namespace bonedecimate
{
namespace
{
std::string WholeFile(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Line ends of every system as LF: VTK's reader takes CR for a part of names and texts.
void UnifyLineEnds(std::string& text)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const bool isPair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!isPair)
    {
      text[kept++] = text[i] == '\r' ? '\n' : text[i];
    }
  }
  text.resize(kept);
}

/// The text of a file that VTK's reader does not take as it is: with a byte-order mark or with CR
/// in line ends. Empty: it takes it.
std::string NormalizedText(const std::string& path)
{
  const std::string mark = "\xEF\xBB\xBF";
  LineReader lines(path);
  bool hasMark = false;
  for (int i = 0; i < 3; ++i) // version, title, ASCII or BINARY
  {
    lines.Next();
    hasMark = hasMark || (i == 0 && lines.GetLine().rfind(mark, 0) == 0);
  }
  const bool isText = Trimmed(lines.GetLine()).substr(0, 1).find_first_of("aA") == 0;
  if (!isText && !hasMark)
  {
    return {};
  }
  std::string text = WholeFile(path);
  const bool hasReturns = isText && text.find('\r') != std::string::npos;
  const bool isTooLong = text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max());
  if ((!hasMark && !hasReturns) || isTooLong)
  {
    return {};
  }
  text.erase(0, hasMark ? mark.size() : 0);
  if (hasReturns)
  {
    UnifyLineEnds(text);
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
