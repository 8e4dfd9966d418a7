/// Must fail: an error that is not a number keeps no limit.

#include "vnv/case.hpp"

using namespace touchstone::vnv;

Case touchstone::vnv::the_case() {
  return {
      .title = "Not a number",
      .times = {1},
      .measurements = {[](const Level& level, const Run&) {
        return std::vector<Value>{{level.name, level.spacing, 1, {"L2 v_x", "%", Kind::norm}, not_a_number}};
      }},
      .methods = {{
          .name = "broken",
          .run = [](const Level&,
                    const Schedule&) { return Run{.summary = {.finished = true, .outcome = "finished"}}; },
          .levels = {{.name = "only", .spacing = 1, .acceptance = 1}},
          .claims = {at_most({"L2 v_x", "%", Kind::norm}, 1e300, theory("not a number is no small number"))},
      }},
  };
}
