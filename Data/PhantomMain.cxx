// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PhantomMain.cxx
 * @brief bonedecimate-phantom: writes a synthetic CT of a broken leg, or a label map of its bones.
 */
#include "FracturedLeg.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace
{
struct Scan
{
  std::array<int, 3> Size;
  phantom::Point Spacing; ///< mm
  phantom::Point Origin;  ///< mm, LPS
  int Decimals;           ///< Of the spacing in the header.
};

/// The whole of the bone, also on a grid as fine as that of a clinical CT, or the fracture alone on a coarser grid.
const Scan NormalScan{ { { 192, 192, 152 } }, { 0.6, 0.6, 1.0 }, { -54.3, -49.3, -141.0 }, 1 };
const Scan LargeScan{ { { 512, 512, 274 } }, { 0.225, 0.225, 0.555 }, { -54.3, -49.3, -141.0 }, 3 };
const Scan SmallScan{ { { 84, 84, 48 } }, { 0.9, 0.9, 1.5 }, { -34.0, -35.0, -120.0 }, 1 };

enum ExitCode
{
  Done = 0,
  Usage = 1,
  CouldNotWrite = 3
};

/// HU of the scanner's noise, about the same spread everywhere.
double ScannerNoise(int i, int j, int k)
{
  double sum = 0.0;
  for (std::uint32_t seed = 101; seed < 105; ++seed)
  {
    sum += phantom::Hash(i, j, k, seed);
  }
  return 16.0 * sum;
}

enum class Content
{
  Intensities,
  Labels
};

/// HU with noise.
void AddIntensity(const phantom::Point& p, const std::array<int, 3>& at, std::vector<char>& bytes)
{
  const double value =
    phantom::Clamped(phantom::LegValue(p) + ScannerNoise(at[0], at[1], at[2]), -1024.0, 3071.0);
  // Shifted to be positive, so that cutting off the fraction rounds to the nearest.
  const int rounded = static_cast<int>(value + 1024.5) - 1024;
  bytes.push_back(static_cast<char>(rounded & 0xff));
  bytes.push_back(static_cast<char>((rounded >> 8) & 0xff));
}

/// Intensities as little-endian 16-bit values, labels as bytes; the first axis runs fastest.
std::vector<char> Voxels(const Scan& scan, Content content)
{
  std::vector<char> bytes;
  for (int k = 0; k < scan.Size[2]; ++k)
  {
    for (int j = 0; j < scan.Size[1]; ++j)
    {
      for (int i = 0; i < scan.Size[0]; ++i)
      {
        const phantom::Point p{ scan.Origin.X + i * scan.Spacing.X,
          scan.Origin.Y + j * scan.Spacing.Y, scan.Origin.Z + k * scan.Spacing.Z };
        if (content == Content::Labels)
        {
          bytes.push_back(static_cast<char>(phantom::LegLabel(p)));
        }
        else
        {
          AddIntensity(p, { { i, j, k } }, bytes);
        }
      }
    }
  }
  return bytes;
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
    content == Content::Labels ? "MET_UCHAR" : "MET_SHORT");
  return std::string(text, static_cast<std::size_t>(length));
}

/// Whole or not at all.
bool Write(const std::string& path, const Scan& scan, Content content)
{
  const std::string partial = path + ".partial";
  std::ofstream file(partial, std::ios::binary);
  const std::string header = Header(scan, content);
  const std::vector<char> voxels = Voxels(scan, content);
  file.write(header.data(), static_cast<std::streamsize>(header.size()));
  file.write(voxels.data(), static_cast<std::streamsize>(voxels.size()));
  file.close();
  const bool isWritten = file && std::rename(partial.c_str(), path.c_str()) == 0;
  if (!isWritten)
  {
    std::remove(partial.c_str());
  }
  return isWritten;
}
const Scan* FindScan(const std::string& size)
{
  return size == "small" ? &SmallScan
    : size == "normal"   ? &NormalScan
    : size == "large"    ? &LargeScan
                         : nullptr;
}
}

int main(int argumentCount, char** arguments)
{
  std::vector<std::string> words(arguments + 1, arguments + argumentCount);
  const auto labels = std::find(words.begin(), words.end(), "--labels");
  const Content content = labels == words.end() ? Content::Intensities : Content::Labels;
  if (labels != words.end())
  {
    words.erase(labels);
  }
  const bool isSized = words.size() == 3 && words[1] == "--size";
  const Scan* const scan = FindScan(isSized ? words[2] : "normal");
  const bool isUnderstood = (words.size() == 1 || isSized) && scan != nullptr;
  if (!isUnderstood || words[0].empty() || words[0][0] == '-')
  {
    std::fputs(
      "Usage: bonedecimate-phantom OUTPUT.mha [--size small|normal|large] [--labels]\n", stderr);
    return Usage;
  }
  if (!Write(words[0], *scan, content))
  {
    std::fprintf(stderr, "%s could not be written.\n", words[0].c_str());
    return CouldNotWrite;
  }
  return Done;
}
