#pragma once
/// A suite's claims beside those that were last accepted.

#include "reports/read/cases.hpp"
#include "vnv/record/accepted_claims.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// Each empty if there is nothing to say.
struct ClaimsStatus {
  std::string missing{};  // "3 claims fewer than accepted: poiseuille.mpm_affine (all)": red
  std::string note{};     // what there is more, and what was not run: not red
};

/// A method with a record makes no fewer claims than accepted, unless one of them fails, which is red or known anyway;
/// if the whole suite was run, each accepted method has a record.
ClaimsStatus claims_status(const std::vector<CaseRecords>& cases, const vnv::AcceptedClaims& accepted, bool whole);

}  // namespace touchstone::reports
