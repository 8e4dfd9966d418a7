#include "reports/pages/pages.hpp"

#include "reports/pages/verdicts.hpp"

namespace touchstone::reports::pages {

Page verdicts() {
  return {
      .title = "Verdicts",
      .sentence = "Every claim with its value, its limit and who set that",
      .content = [](const Findings& all) -> Content {
        const Tally sum = tally(verdicts_of(all.cases));
        const auto section = [](const CaseRecords& records) {
          const std::size_t rows = verdicts_of(records).size();
          return object("case"_ = records.name, "height"_ = std::to_string(4 + 3 * rows),
                        "claims"_ = claims_data(records));
        };
        return {object("kind"_ = word(sum.worst()), "sentence"_ = sentence(sum), "cases"_ = each(all.cases, section))};
      }};
}

}  // namespace touchstone::reports::pages
