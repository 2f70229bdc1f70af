// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PhantomScan.h
 * @brief Synthetic scans of a broken leg, as MetaImage files.
 */
#ifndef PhantomScan_h
#define PhantomScan_h

#include "Shapes.h"

#include <array>
#include <string>

namespace phantom
{
struct Scan
{
  std::array<int, 3> Size;
  Point Spacing; ///< mm
  Point Origin;  ///< mm, LPS
  int Decimals;  ///< Decimals of the spacing in the header.
};

enum class Content
{
  Intensities, ///< HU of a CT.
  Labels,
  Trabeculae
};

/// The leg as "normal", as "large" as a clinical CT, or its fracture alone, "small" and coarser;
/// null: there is no scan of that size.
const Scan* FindScan(const std::string& size);

/// Whole or not at all; whether it was written.
bool WriteScan(const std::string& path, const Scan& scan, Content content);
}

#endif
