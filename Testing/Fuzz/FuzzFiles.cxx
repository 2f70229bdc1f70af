// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzFiles.cxx
 * @brief Fuzzes all readers of surfaces with any bytes: they must be accepted, or rejected with a message.
 *
 *     bytes:  one that selects the reader, then the file; of 3MF also its model alone, which the harness puts into an archive
 */
#include "Bytes.h"
#include "ExitCode.h"
#ifdef BONEDECIMATE_FUZZ_WITH_VTK
#include "CoordinateCollector.h"
#include "FileChecks.h"
#include "GlbFiles.h"
#include "SurfaceReaders.h"
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
constexpr int GlbKind = 5;
constexpr int ArchiveKind = 6;
constexpr int ModelKind = 7;
constexpr int Kinds = 8;

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

void ReadAs(int kind, const std::string& path)
{
#ifdef BONEDECIMATE_FUZZ_WITH_VTK
  std::vector<std::string> warnings;
  CoordinateCollector points;
  switch (kind)
  {
    case 0:
      return CheckSurface(ReadObjFile(path, warnings));
    case 1:
      return CheckSurface(ReadStlFile(path, warnings));
    case 2:
      return CheckSurface(ReadPlyFile(path, warnings));
    case 3:
      return CheckVtkFile(path, points);
    case 4:
      return CheckVtpFile(path, points);
#ifdef BONEDECIMATE_HAS_MESHOPTIMIZER
    case GlbKind:
      return CheckSurface(ReadGlbFile(path, warnings));
#endif
#ifdef BONEDECIMATE_HAS_LIBZIP
    case ArchiveKind:
    case ModelKind:
      return CheckSurface(ReadThreeMfFile(path, warnings));
#endif
    default: // a format that this build does not have
      return;
  }
#else
  static_cast<void>(kind);
  static_cast<void>(path);
#endif
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Scratch scratch;
  Bytes bytes(data, size);
  const int kind = bytes.Below(Kinds);
  scratch.Write(bytes);
#ifdef BONEDECIMATE_HAS_LIBZIP
  if (kind == ModelKind)
  {
    PutIntoArchive(bytes, scratch.Path);
  }
#endif
  try
  {
    ReadAs(kind, scratch.Path);
  }
  catch (const Failure& failure)
  {
    if (failure.Code != ExitCode::InputRejected || std::string(failure.what()).empty())
    {
      std::fprintf(stderr, "broken: rejected with code %d\n", static_cast<int>(failure.Code));
      std::abort();
    }
  }
  return 0;
}
