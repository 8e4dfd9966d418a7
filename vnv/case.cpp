#include "vnv/case.hpp"

#include <algorithm>

namespace touchstone::vnv {

std::string_view name_of(Suite suite) {
  return suite == Suite::acceptance ? "acceptance" : suite == Suite::report ? "report" : "nightly";
}

const Run* Results::run(std::string_view level) const {
  for (const Run& r : runs)
    if (r.summary.level == level) return &r;
  return nullptr;
}

Case with_plots(Case declared, const std::vector<Plot>& plots) {
  declared.plots.insert(declared.plots.end(), plots.begin(), plots.end());
  return declared;
}

}  // namespace touchstone::vnv
