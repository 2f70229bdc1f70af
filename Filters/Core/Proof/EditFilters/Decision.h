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
/// Deferred: the decision needs a part of the mesh that belongs to another worker. It is no
/// rejection and is not counted; the schedule proposes the edit again when the parts are divided
/// differently.
class Decision
{
public:
  /// Accepted if the reason is NotRejected.
  Decision(Rejection reason)
    : Why(reason)
  {
  }
  static Decision Accept() { return Rejection::NotRejected; }
  static Decision Defer()
  {
    Decision decision = Rejection::NotRejected;
    decision.IsPostponed = true;
    return decision;
  }

  bool IsAccepted() const { return this->Why == Rejection::NotRejected && !this->IsPostponed; }
  bool IsRejected() const { return this->Why != Rejection::NotRejected; }
  bool IsDeferred() const { return this->IsPostponed; }
  /// NotRejected if it is accepted or deferred.
  Rejection Reason() const { return this->Why; }

  friend bool operator==(Decision a, Decision b)
  {
    return a.Why == b.Why && a.IsPostponed == b.IsPostponed;
  }
  friend bool operator!=(Decision a, Decision b) { return !(a == b); }

private:
  Rejection Why;
  bool IsPostponed = false;
};
}

#endif
