/// Start-up of plane Poiseuille flow [Sun et al., section 3.1].

#include "reference/poiseuille.hpp"
#include "solvers/walls/no_slip.hpp"
#include "vnv/flows/channels/plates.hpp"

namespace touchstone::vnv::flows {

Flow poiseuille(Settings& set) {
  const Plates plates(set);
  const double F = set("F", channel::drive, "m/s²", "body force along x, per mass, from t = 0 on");
  const auto force = [=](const Changes& by) { return F * (1 + by(Cause::force)); };
  const Altered exact = plates.slipping(
      [=](const Changes& by) { return reference::Poiseuille{.H = plates.H(by), .F = force(by), .nu = plates.nu(by)}; },
      force, 0, 0);
  Flow flow = with_row_means(
      plates.flow(
          "Start-up of plane Poiseuille flow",
          "Fluid at rest between two plates at rest is driven along them by a body force from t = 0. The oracle is the "
          "exact series of Morris, Fox & Zhu (1997).",
          plates.times({0.05, 0.1, 0.2, 1}), no_slip(), no_slip(), exact, of_two_plates_and_force, true),
      exact);
  flow.drive = {{F, 0}};
  const double H = plates.H();
  const reference::Poiseuille right{.H = H, .F = F, .nu = plates.nu()}, twice{2 * H, F, plates.nu()};
  flow.exact[0].instead = {
      slips_along("both walls, or has no viscosity", [=](double, double t) { return F * t; }),
      slips_along("the lower wall", [=](double y, double t) { return twice(y + H, t); }),
      slips_along("the upper wall", twice),
      is_steady([=](double y, double) { return right.steady(y); }),
  };
  return flow;
}

}  // namespace touchstone::vnv::flows
