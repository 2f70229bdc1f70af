// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EditProof.h
 * @brief What a Prover found about the edit that was checked last. It waits for its commit here, so
 * that a few provers, whose memory is
 *        in proportion to the mesh, serve many edits.
 */
#ifndef BoneDecimate_Core_Proof_ErrorBound_EditProof_h
#define BoneDecimate_Core_Proof_ErrorBound_EditProof_h

#include "Coverage.h"
#include "Proof/EditFilters/EditFilter.h"

#include <cstdint>
#include <vector>

namespace bonedecimate
{
/// An original, or an edge of its boundaries, with covering elements that the edit changes.
struct CoveredItem
{
  Index Id;
  std::uint32_t Gone;            // bits of its slots whose covering elements change
  std::uint64_t Used = 0;        // of the new elements, those that prove it
  Coverage::Version Version = 0; // of its coverage when it was proved
};

struct EditProof : public EditFilter::Pending
{
  std::vector<CoveredItem> Items;
  std::vector<CoveredItem> BoundaryItems;
  Index Nearest = None;           // an original triangle near the vertex that moves
  Index NearestBoundary = None;   // an original boundary edge near it
  std::vector<Index> NewElements; // memory of the commit
};
}

#endif
