/// Must fail: a run that nobody claims anything of is no proof.

#include "vnv/case.hpp"

using namespace touchstone::vnv;

Case touchstone::vnv::the_case() {
  return {
      .title = "Claims nothing",
      .times = {1},
      .measurements = {},
      .methods = {{
          .name = "silent",
          .run = [](const Level&,
                    const Schedule&) { return Run{.summary = {.finished = true, .outcome = "finished"}}; },
          .levels = {{.name = "only", .spacing = 1, .acceptance = 1}},
      }},
  };
}
