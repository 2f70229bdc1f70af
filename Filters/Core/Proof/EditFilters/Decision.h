// SPDX-FileCopyrightText: Copyright (c) vtkBoneDecimate contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Decision.h
 * @brief What becomes of a proposed edit: it is accepted, rejected for a reason, or deferred.
 */
#ifndef BoneDecimate_Core_Proof_EditFilters_Decision_h
#define BoneDecimate_Core_Proof_EditFilters_Decision_h

#include "Figures/Rejection.h"

namespace bonedecimate
{
/// Deferred: the decision needs a part of the mesh that belongs to another worker. This is no
/// rejection and is not counted. The schedule proposes the edit again when the mesh is divided
/// differently.
class Decision
{
public:
  /// Accepted if the reason is NotRejected.
  Decision(Rejection reason)
    : RejectionReason(reason)
  {
  }
  static Decision Accept() { return Rejection::NotRejected; }
  static Decision Defer()
  {
    Decision decision = Rejection::NotRejected;
    decision.MustWait = true;
    return decision;
  }

  bool IsAccepted() const
  {
    return this->RejectionReason == Rejection::NotRejected && !this->MustWait;
  }
  bool IsRejected() const { return this->RejectionReason != Rejection::NotRejected; }
  bool IsDeferred() const { return this->MustWait; }
  /// NotRejected if it is accepted or deferred.
  Rejection Reason() const { return this->RejectionReason; }

  friend bool operator==(Decision a, Decision b)
  {
    return a.RejectionReason == b.RejectionReason && a.MustWait == b.MustWait;
  }
  friend bool operator!=(Decision a, Decision b) { return !(a == b); }

private:
  Rejection RejectionReason;
  bool MustWait = false;
};
}

#endif
