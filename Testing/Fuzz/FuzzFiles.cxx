// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzFiles.cxx
 * @brief Fuzzes all readers of surfaces with any bytes: they must be accepted, or rejected with a
 * message.
 *
 *     bytes:  one that selects the reader, then the file: 0 is the model of a 3MF file alone, which
 *             the harness puts into an
 *             archive, and n the format of the n-th row of the table
 */
#include "Bytes.h"
#include "ExitCode.h"
#ifdef BONEDECIMATE_FUZZ_WITH_VTK
#include "CoordinateCollector.h"
#include "SurfaceFormat.h"
#include "ThreeMfFiles.h"
#endif

#ifdef BONEDECIMATE_FUZZ_WITH_VTK
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#endif

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#ifdef BONEDECIMATE_HAS_LIBZIP
#include <zip.h>
#endif

using namespace bonedecimate;
using bonedecimate::testsupport::Bytes;

namespace
{
#ifdef BONEDECIMATE_HAS_LIBZIP
constexpr int ModelKind = 0;
#endif

/// A file of this process, rewritten for each input.
class Scratch
{
public:
  Scratch()
    : Path(
        (std::filesystem::temp_directory_path() / ("fuzzed-" + std::to_string(getpid()))).string())
  {
  }
  ~Scratch() { std::remove(this->Path.c_str()); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  void Write(const Bytes& bytes) const
  {
    std::ofstream(this->Path, std::ios::binary)
      .write(
        reinterpret_cast<const char*>(bytes.Rest()), static_cast<std::streamsize>(bytes.Count()));
  }

  const std::string Path;
};

#ifdef BONEDECIMATE_FUZZ_WITH_VTK
/// Every corner is a point, and every array has a tuple for each point or cell.
void CheckSurface(vtkPolyData* surface)
{
  vtkCellArray* polygons = surface->GetPolys();
  bool isWhole = polygons->IsValid() && surface->CheckAttributes() == 0;
  for (vtkIdType i = 0; isWhole && i < polygons->GetNumberOfConnectivityIds(); ++i)
  {
    const double corner = polygons->GetConnectivityArray()->GetTuple1(i);
    isWhole = corner >= 0.0 && corner < static_cast<double>(surface->GetNumberOfPoints());
  }
  if (!isWhole)
  {
    std::fputs("broken: a surface with corners or arrays that do not fit\n", stderr);
    std::abort();
  }
}
#endif

#ifdef BONEDECIMATE_HAS_LIBZIP
/// Compressed and with a checksum, a model would hardly ever be changed into another one by chance.
void PutIntoArchive(const Bytes& model, const std::string& path)
{
  int error = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
  zip_source_t* source =
    archive == nullptr ? nullptr : zip_source_buffer(archive, model.Rest(), model.Count(), 0);
  if (source == nullptr || zip_file_add(archive, ThreeMfModel, source, ZIP_FL_ENC_UTF_8) < 0 ||
    zip_close(archive) != 0)
  {
    std::fputs("broken: the harness cannot write an archive\n", stderr);
    std::abort();
  }
}
#endif

#ifdef BONEDECIMATE_FUZZ_WITH_VTK
/// What libraries read is checked before, and libraries are fuzzed by others.
void ReadAs(const SurfaceFormat& format, const std::string& path)
{
  if (!format.MissingLibrary.empty())
  {
    return;
  }
  std::vector<std::string> warnings;
  CoordinateCollector points;
  if (format.Check != nullptr)
  {
    return format.Check(path, points);
  }
  CheckSurface(format.Read(path, warnings));
}

void ReadAs(std::size_t kind, const std::string& path)
{
  const std::vector<const SurfaceFormat*>& formats = SurfaceFormats();
  const SurfaceFormat* const archive = FindFormat("model.3mf");
  ReadAs(kind == 0 ? *archive : *formats[kind - 1], path);
}
#endif
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Scratch scratch;
  Bytes bytes(data, size);
#ifdef BONEDECIMATE_FUZZ_WITH_VTK
  const int kind = bytes.Below(static_cast<int>(SurfaceFormats().size()) + 1);
  scratch.Write(bytes);
#ifdef BONEDECIMATE_HAS_LIBZIP
  if (kind == ModelKind)
  {
    PutIntoArchive(bytes, scratch.Path);
  }
#endif
  try
  {
    ReadAs(static_cast<std::size_t>(kind), scratch.Path);
  }
  catch (const Failure& failure)
  {
    if (failure.Code != ExitCode::InputRejected || std::string(failure.what()).empty())
    {
      std::fprintf(stderr, "broken: rejected with code %d\n", static_cast<int>(failure.Code));
      std::abort();
    }
  }
#endif
  return 0;
}
