// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertificatePage.h
 * @brief One self-contained HTML page about a certificate.
 */
#ifndef BoneDecimate_Applications_CertificatePage_h
#define BoneDecimate_Applications_CertificatePage_h

#include "PairView.h"

#include <string>

namespace bonedecimate
{
/// @param certificate As the program writes it (Documentation/certificate.schema.json).
/// @param pair The reference and the result with the distances of their points; without surfaces
///   the page has no view.
/// @param pictureFile A PNG to embed; empty: no picture.
/// @returns The page as HTML text.
std::string ComposeCertificatePage(
  const std::string& certificate, const PairSubject& pair, const std::string& pictureFile);
}

#endif
