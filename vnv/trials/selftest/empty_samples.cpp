/// Must fail: no particles have no error, and that is no small one.

#include "vnv/case.hpp"
#include "vnv/measures/norms_of.hpp"
#include "vnv/measures/profile.hpp"

using namespace touchstone;
using namespace touchstone::vnv;

Case vnv::the_case() {
  return {
      .title = "Empty samples",
      .times = {1},
      .measurements = {norms_of(
          "v_x", [](const Level&) { return per_particle(velocity_x); }, [](double, double) { return 1.0; })},
      .methods = {{
          .name = "empty",
          .run =
              [](const Level&, const Schedule&) {
                return Run{.summary = {.finished = true, .outcome = "finished"}, .samples = {Samples{.time = 1}}};
              },
          .levels = {{.name = "only", .spacing = 1, .acceptance = 1}},
          .claims = {at_most({"L2 v_x", "%", Kind::norm}, 1e300, theory("there must be something to compare"))},
      }},
  };
}
