// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PhantomScan.h"

#include "FracturedLeg.h"
#include "Trabeculae.h"

#include <cstdio>
#include <fstream>
#include <vector>

namespace phantom
{
namespace
{
/// The whole of the bone, also on a grid as fine as that of a clinical CT, or the fracture alone on
/// a coarser grid.
const Scan NormalScan{ { { 192, 192, 152 } }, { 0.6, 0.6, 1.0 }, { -54.3, -49.3, -141.0 }, 1 };
const Scan LargeScan{ { { 512, 512, 274 } }, { 0.225, 0.225, 0.555 }, { -54.3, -49.3, -141.0 }, 3 };
const Scan SmallScan{ { { 84, 84, 48 } }, { 0.9, 0.9, 1.5 }, { -34.0, -35.0, -120.0 }, 1 };

/// HU of the scanner's noise, about the same spread everywhere.
double ScannerNoise(int i, int j, int k)
{
  double sum = 0.0;
  for (std::uint32_t seed = 101; seed < 105; ++seed)
  {
    sum += Hash(i, j, k, seed);
  }
  return 16.0 * sum;
}

/// HU with noise.
void AddIntensity(const Point& p, const std::array<int, 3>& at, std::vector<char>& bytes)
{
  const double value = Clamped(LegValue(p) + ScannerNoise(at[0], at[1], at[2]), -1024.0, 3071.0);
  // Shifted to be positive, so that cutting off the fraction rounds to the nearest.
  const int rounded = static_cast<int>(value + 1024.5) - 1024;
  bytes.push_back(static_cast<char>(rounded & 0xff));
  bytes.push_back(static_cast<char>((rounded >> 8) & 0xff));
}

/// Appends a layer of the leg: intensities as little-endian 16-bit values, labels as bytes; the
/// first axis runs fastest.
void AppendLegLayer(const Scan& scan, Content content, int k, std::vector<char>& bytes)
{
  for (int j = 0; j < scan.Size[1]; ++j)
  {
    for (int i = 0; i < scan.Size[0]; ++i)
    {
      const Point p{ scan.Origin.X + i * scan.Spacing.X, scan.Origin.Y + j * scan.Spacing.Y,
        scan.Origin.Z + k * scan.Spacing.Z };
      if (content == Content::Labels)
      {
        bytes.push_back(static_cast<char>(LegLabel(p)));
      }
      else
      {
        AddIntensity(p, { { i, j, k } }, bytes);
      }
    }
  }
}

/// Layer by layer, because a volume may be larger than memory.
void WriteVoxels(const Scan& scan, Content content, std::ofstream& file)
{
  Trabeculae trabeculae(content == Content::Trabeculae ? scan.Size[0] : 0);
  std::vector<char> bytes;
  for (int k = 0; k < scan.Size[2] && file; ++k)
  {
    bytes.clear();
    if (content == Content::Trabeculae)
    {
      trabeculae.AppendLayer(k, bytes);
    }
    else
    {
      AppendLegLayer(scan, content, k, bytes);
    }
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
}

std::string Header(const Scan& scan, Content content)
{
  char text[512];
  const int length = std::snprintf(text, sizeof(text),
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
    "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = %.1f %.1f %.1f\n"
    "ElementSpacing = %.*f %.*f %.*f\nDimSize = %d %d %d\nElementType = %s\n"
    "ElementDataFile = LOCAL\n",
    scan.Origin.X, scan.Origin.Y, scan.Origin.Z, scan.Decimals, scan.Spacing.X, scan.Decimals,
    scan.Spacing.Y, scan.Decimals, scan.Spacing.Z, scan.Size[0], scan.Size[1], scan.Size[2],
    content == Content::Intensities ? "MET_SHORT" : "MET_UCHAR");
  return std::string(text, static_cast<std::size_t>(length));
}
}

const Scan* FindScan(const std::string& size)
{
  return size == "small" ? &SmallScan
    : size == "normal"   ? &NormalScan
    : size == "large"    ? &LargeScan
                         : nullptr;
}

bool WriteScan(const std::string& path, const Scan& scan, Content content)
{
  const std::string partial = path + ".partial";
  std::ofstream file(partial, std::ios::binary);
  const std::string header = Header(scan, content);
  file.write(header.data(), static_cast<std::streamsize>(header.size()));
  WriteVoxels(scan, content, file);
  file.close();
  const bool isWritten = file && std::rename(partial.c_str(), path.c_str()) == 0;
  if (!isWritten)
  {
    std::remove(partial.c_str());
  }
  return isWritten;
}
}
