// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DicomFiles.h
 * @brief Writes scans as series of DICOM slices, with GDCM.
 */
#ifndef BoneDecimate_Testing_DicomFiles_h
#define BoneDecimate_Testing_DicomFiles_h

#include "Specimen.h"

#include <gdcmPhotometricInterpretation.h>
#include <gdcmTransferSyntax.h>

#include <string>

namespace bonedecimate::testing
{
struct SeriesOptions
{
  std::string Prefix = "slice"; ///< File names begin so.
  std::string Series = "1";     ///< End of the unique identifiers.
  std::string Modality = "CT";
  double Slope = 1.0;
  double Intercept = 0.0;
  std::size_t First = 0;    ///< The slices from this one on,
  std::size_t Count = 1000; ///< at most so many.
  int Frames = 1;           ///< What the header says.
  gdcm::TransferSyntax::TSType Syntax = gdcm::TransferSyntax::ExplicitVRLittleEndian;
  gdcm::PhotometricInterpretation::PIType Colors = gdcm::PhotometricInterpretation::MONOCHROME2;
};

/// Writes one file for each slice. The order of names is not that of slices; the patient is called
/// Secret^Patient.
void WriteDicom(const std::string& folder, const Scan& scan, const SeriesOptions& options = {});
}

#endif
