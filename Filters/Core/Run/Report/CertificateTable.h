// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CertificateTable.h
 * @brief A certificate as a flat list of named values, like ReportTable.h for a report.
 */
#ifndef BoneDecimate_Core_Run_Report_CertificateTable_h
#define BoneDecimate_Core_Run_Report_CertificateTable_h

#include "Figures/ComparedFigures.h"
#include "Figures/LeftOut.h"
#include "Proof/Certificate/Certificate.h"
#include "ReportTable.h"

#include <optional>
#include <vector>

namespace bonedecimate
{
/// What is known besides the certificate.
struct PairFigures
{
  std::vector<bonedecimate::LeftOut> LeftOut; ///< From both surfaces.
  std::optional<ComparedFigures> Reference;
  std::optional<ComparedFigures> Result;
  std::vector<MissingComponent> Missing; ///< If both were measured; the largest first.
};

/**
 * All entries, always in the same order: version, problem, status, stopped (only after an abort),
 * lower, upper, sentence, slack, boundaries (or "not_compared"), seconds; reference and result, if
 * they were measured: .triangles, .points, .components, .boundary_edges, .non_manifold_edges,
 * .euler_number, .area, .volume, .intersecting_pairs, .diagonal, .checksum; for each component of
 * the reference that has no counterpart in the result missing.0.triangles, .diagonal, .x, .y, .z;
 * left_out, as in a report, of both surfaces; then for each of reference_to_result,
 * result_to_reference and, if a surface has boundaries, boundary_reference_to_result and
 * boundary_result_to_reference: .status, .lower, .upper, .x, .y, .z, .triangle, .nearest_triangle,
 * .cuts; with a map .excess.{lower, upper, x, y, z, triangle, nearest_triangle, cuts}; with means
 * .mean, .mean_error, .rms, .rms_error, .area, .samples. A certificate with a problem has only the
 * first three.
 */
std::vector<ReportEntry> CertificateEntries(
  const Certificate& certificate, const PairFigures& pair = {});

/// The entry "stopped" of a certificate that was aborted.
extern const char* const StoppedSentence;

/// One word: "both".
const char* BoundaryPresenceWord(BoundaryPresence presence);
}

#endif
