// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "DicomFiles.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageWriter.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>
#include <gdcmWriter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <vector>

namespace bonedecimate::testing
{
using volume::Cross;
using volume::Length;

namespace
{
const std::string Root = "1.2.826.0.1.3680043.8.498.";

std::string NumberText(double value)
{
  std::ostringstream text;
  text << std::setprecision(10) << value;
  return text.str();
}

/// Numbers as DICOM writes them, with backslashes in between.
std::string ListText(const std::vector<double>& values)
{
  std::string text;
  for (const double value : values)
  {
    text += (text.empty() ? "" : "\\") + NumberText(value);
  }
  return text;
}

void SetText(gdcm::DataSet& data, const gdcm::Tag& tag, gdcm::VR::VRType type, std::string text)
{
  const char filler = type == gdcm::VR::UI ? '\0' : ' ';
  text.append(text.size() % 2, filler);
  gdcm::DataElement element(tag);
  element.SetVR(type);
  element.SetByteValue(text.data(), gdcm::VL(static_cast<std::uint32_t>(text.size())));
  data.Replace(element);
}

void SetHeader(gdcm::DataSet& data, const SeriesOptions& options, std::size_t slice)
{
  SetText(data, { 0x0008, 0x0016 }, gdcm::VR::UI, "1.2.840.10008.5.1.4.1.1.2"); // CT image storage
  SetText(data, { 0x0008, 0x0018 }, gdcm::VR::UI,
    Root + "3." + options.Series + "." + std::to_string(slice + 1));
  SetText(data, { 0x0008, 0x0060 }, gdcm::VR::CS, options.Modality);
  SetText(data, { 0x0010, 0x0010 }, gdcm::VR::PN, "Secret^Patient");
  SetText(data, { 0x0010, 0x0020 }, gdcm::VR::LO, "Secret0815");
  SetText(data, { 0x0020, 0x000d }, gdcm::VR::UI, Root + "1");
  SetText(data, { 0x0020, 0x000e }, gdcm::VR::UI, Root + "2." + options.Series);
}

void SetGeometry(gdcm::DataSet& data, const VolumeGeometry& geometry, std::size_t slice)
{
  const auto& steps = geometry.Steps;
  std::vector<double> position;
  std::vector<double> orientation;
  for (std::size_t i = 0; i < 3; ++i)
  {
    position.push_back(geometry.Origin[i] + static_cast<double>(slice) * steps[2][i]);
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      orientation.push_back(steps[axis][i] / Length(steps[axis]));
    }
  }
  SetText(data, { 0x0020, 0x0032 }, gdcm::VR::DS, ListText(position));
  SetText(data, { 0x0020, 0x0037 }, gdcm::VR::DS, ListText(orientation));
  SetText(data, { 0x0028, 0x0030 }, gdcm::VR::DS, ListText({ Length(steps[1]), Length(steps[0]) }));
}

/// Stored values of one slice.
void SetPixels(
  gdcm::Image& image, const Scan& scan, const SeriesOptions& options, std::size_t slice)
{
  const bool isGrey = options.Colors == gdcm::PhotometricInterpretation::MONOCHROME2;
  const std::size_t count = scan.Size[0] * scan.Size[1];
  std::vector<short> stored(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double value = scan.Values[slice * count + i];
    stored[i] = static_cast<short>(std::lround((value - options.Intercept) / options.Slope));
  }
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned int>(scan.Size[0]));
  image.SetDimension(1, static_cast<unsigned int>(scan.Size[1]));
  image.SetPixelFormat(isGrey ? gdcm::PixelFormat(gdcm::PixelFormat::INT16)
                              : gdcm::PixelFormat(gdcm::PixelFormat::UINT8));
  if (!isGrey)
  {
    gdcm::PixelFormat colors = gdcm::PixelFormat::UINT8;
    colors.SetSamplesPerPixel(3);
    image.SetPixelFormat(colors);
  }
  image.SetPhotometricInterpretation(options.Colors);
  image.SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  image.SetSlope(options.Slope);
  image.SetIntercept(options.Intercept);
  const std::size_t bytes = count * (isGrey ? 2 : 3);
  stored.resize((bytes + 1) / 2);
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetByteValue(
    reinterpret_cast<const char*>(stored.data()), gdcm::VL(static_cast<std::uint32_t>(bytes)));
  image.SetDataElement(pixels);
}

void WriteSlice(
  const std::string& path, const Scan& scan, const SeriesOptions& options, std::size_t slice)
{
  gdcm::ImageWriter writer;
  SetHeader(writer.GetFile().GetDataSet(), options, slice);
  SetPixels(writer.GetImage(), scan, options, slice);
  gdcm::ImageChangeTransferSyntax change;
  if (options.Syntax != gdcm::TransferSyntax::ExplicitVRLittleEndian)
  {
    change.SetTransferSyntax(options.Syntax);
    change.SetInput(writer.GetImage());
    ASSERT_TRUE(change.Change());
    writer.SetImage(change.GetOutput());
  }
  writer.SetFileName(path.c_str());
  ASSERT_TRUE(writer.Write());
  // The image writer puts its own notion of the geometry there.
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  ASSERT_TRUE(reader.Read());
  gdcm::DataSet& data = reader.GetFile().GetDataSet();
  SetGeometry(data, scan.Geometry, slice);
  SetText(data, { 0x0028, 0x1052 }, gdcm::VR::DS, NumberText(options.Intercept));
  SetText(data, { 0x0028, 0x1053 }, gdcm::VR::DS, NumberText(options.Slope));
  if (options.Frames > 1)
  {
    SetText(data, { 0x0028, 0x0008 }, gdcm::VR::IS, std::to_string(options.Frames));
  }
  gdcm::Writer rewriter;
  rewriter.SetFile(reader.GetFile());
  rewriter.SetFileName(path.c_str());
  ASSERT_TRUE(rewriter.Write());
}
}

void WriteDicom(const std::string& folder, const Scan& scan, const SeriesOptions& options)
{
  std::filesystem::create_directories(folder);
  const std::size_t count = std::min(scan.Size[2] - options.First, options.Count);
  gdcm::Trace::WarningOff();
  for (std::size_t k = options.First; k < options.First + count; ++k)
  {
    // 37 is prime to every number of slices here: the names run through all of them in another
    // order.
    const std::string number = std::to_string(100 + k * 37 % 41);
    WriteSlice(folder + "/" + options.Prefix + number, scan, options, k);
  }
  gdcm::Trace::WarningOn(); // whether our reader is silent must show
}
}
