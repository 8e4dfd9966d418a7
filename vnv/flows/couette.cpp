/// Start-up of plane Couette flow [Sun et al., section 3.2].

#include "reference/couette.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channels/plates.hpp"

namespace touchstone::vnv::flows {

Flow couette(Settings& set) {
  const Plates plates(set);
  const double V = set("V", 0.1 * mm, "m/s", "velocity of the upper plate from t = 0 on");
  const double V_lower = set("V_lower", 0, "m/s", "velocity of the lower plate from t = 0 on");
  const Altered walls = [=](const Changes& by) -> Truth {
    const auto moved = [&](double plate) {
      return reference::Couette{.H = plates.H(by), .V = plate, .nu = plates.nu(by)};
    };
    if (V_lower == 0) return moved(V);
    return
        [upper = moved(V), lower = moved(V_lower)](double y, double t) { return upper(y, t) + lower(lower.H - y, t); };
  };
  const Altered exact = plates.slipping(walls, [](const Changes&) { return 0; }, V_lower, V);
  Flow flow = with_row_means(
      plates.flow(
          "Start-up of plane Couette flow",
          "Fluid at rest between two plates, of which the upper one slides from t = 0, or both do. The oracle is the "
          "exact series of Morris, Fox & Zhu (1997), one for each plate.",
          plates.times({0.05, 0.1, 0.2, 1}), no_slip({V_lower, 0}), no_slip({V, 0}), exact, of_two_plates, true),
      exact);
  const double H = plates.H();
  const auto of_one = [=](double plate) {
    return of_both(reference::Couette{.H = 2 * H, .V = plate, .nu = plates.nu()}, 2 * H);
  };
  flow.exact[0].instead = {
      slips_along("the lower wall", [=, upper = of_one(V)](double y, double t) { return upper(y + H, t); }),
      is_steady([=](double y, double) { return V_lower + (V - V_lower) * y / H; }),
  };
  if (V_lower != 0) flow.exact[0].instead.push_back(slips_along("the upper wall", of_one(V_lower)));
  return flow;
}

}  // namespace touchstone::vnv::flows
