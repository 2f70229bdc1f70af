// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Text.h"
#include "FileChecks.h"
#include "Formats/SurfaceFormat.h"
#include "PlainText.h"
#include "VtkReadersAndWriters.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <map>

namespace bonedecimate
{
namespace
{
vtkSmartPointer<vtkPolyData> ReadVtp(const std::string& path, std::vector<std::string>&)
{
  CoordinateCollector textPoints;
  CheckVtpFile(path, textPoints);
  const vtkNew<vtkXMLPolyDataReader> reader;
  const vtkSmartPointer<vtkPolyData> surface = ReadWith(reader.Get(), path, textPoints);
  const bool hasBoth = surface->GetNumberOfPolys() > 0 && surface->GetNumberOfStrips() > 0;
  if (hasBoth && reader->GetNumberOfPieces() > 1 && surface->GetCellData()->GetNumberOfArrays() > 0)
  {
    Reject(path,
      "it has arrays of polygons and of strips in several pieces, which VTK mixes up; save it in "
      "one piece");
  }
  return surface;
}

/// Names of arrays as XML has them, as long as this lives: VTK writes them as they are.
class NamesAsXml
{
public:
  explicit NamesAsXml(vtkPolyData* surface)
  {
    for (vtkFieldData* data : { static_cast<vtkFieldData*>(surface->GetPointData()),
           static_cast<vtkFieldData*>(surface->GetCellData()), surface->GetFieldData() })
    {
      for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      {
        this->Take(data->GetAbstractArray(i));
      }
    }
  }
  ~NamesAsXml()
  {
    for (const auto& [array, name] : this->Names)
    {
      array->SetName(name.c_str());
    }
  }
  NamesAsXml(const NamesAsXml&) = delete;
  NamesAsXml& operator=(const NamesAsXml&) = delete;

private:
  void Take(vtkAbstractArray* array)
  {
    const std::string name = array->GetName() != nullptr ? array->GetName() : "";
    const std::string text = EscapedXml(PlainText(name));
    if (text != name && this->Names.emplace(array, name).second)
    {
      array->SetName(text.c_str());
    }
  }

  std::map<vtkAbstractArray*, std::string> Names; // that were changed; an array may be there twice
};

void WriteVtp(vtkPolyData* surface, const std::string& path)
{
  const NamesAsXml names(surface);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  WriteWith(writer.Get(), surface, path);
}

SurfaceFormat VtpRow()
{
  SurfaceFormat format = { "vtp", true, true, true, ReadVtp, WriteVtp };
  format.Check = CheckVtpFile;
  return format;
}
}

extern const SurfaceFormat VtpFormat;
const SurfaceFormat VtpFormat = VtpRow();
}
