// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertificatePage.h
 * @brief One self-contained HTML page about a certificate.
 */
#ifndef BoneDecimate_Applications_CertificatePage_h
#define BoneDecimate_Applications_CertificatePage_h

#include "PairView.h"
#include "Picture.h"

#include <optional>
#include <string>

namespace bonedecimate
{
/// What the picture of a certificate marks: the largest distance or, if nothing else violates the
/// tolerance, an open boundary. Empty if the two surfaces are the same.
std::optional<PictureMark> MarkOfCertificate(const std::string& certificate);

/// @param certificate As the program writes it (Documentation/certificate.schema.json).
/// @param pair The reference and the result with the distances of their points; without surfaces
///   the page has no view.
/// @param pictureFile A PNG to embed; empty: no picture.
/// @returns The page as HTML text.
std::string ComposeCertificatePage(
  const std::string& certificate, const PairSubject& pair, const std::string& pictureFile);
}

#endif
