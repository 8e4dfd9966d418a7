#include "reports/pages/pages.hpp"

namespace touchstone::reports::pages {

Page a_verdict_fails() {
  return {.title = "A verdict fails",
          .sentence = "From the red line to its cause, and what to do then",
          .content = [](const Findings&) -> Content { return {object()}; }};
}

}  // namespace touchstone::reports::pages
