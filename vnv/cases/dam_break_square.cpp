/// The square column of Martin & Moyce (1952), 2.25 in, released at once: front and residual height beside theirs.

#include "vnv/flows/dams/dam_methods.hpp"
#include "vnv/flows/dams/open_dam.hpp"

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::open_dam;

namespace {

const DamFront& dam = martin_moyce_square;

/// As a flat plate as long as the column has, all laminar, at 2 sqrt(g h0): 0.664 Re^(-1/2), Re = 8.6e4 (Blasius 1908).
const SkinFriction plate{.coefficient = 0.0023, .layer = 0.05715 / 40};

/// On the finest level, whose error of the front speed was so large when first measured.
std::vector<Claim> finest(const std::string& level, double first) {
  return {
      at_most(
          dam.rms_of(of_slab, "Lobovský et al. 2014"), 0.17,
          literature("the experiments of two authors with the same column differ by this much, one by Martin & Moyce "
                     "(1952)"))
          .on(level),
      at_most(
          dam.rms_of(dam.of_residual_height, martin_moyce), 0.08,
          literature("the height falls by 0.08 in 0.3 of T, the uncertainty of the time origin (Martin & Moyce 1952)"))
          .on(level),
      between(dam.speed_error_of(of_slab, martin_moyce), first - 4.5, first + 4.5,
              baseline("value when first measured ± the 4.5 % by which two experiments with the same column differ"))
          .on(level)};
}

constexpr const char* of_sheet =
    "the front is a sheet of single particles at last: in twelve runs of APIC, 20 across, whose time steps differ by "
    "1e-10, the error of its speed is 14 to 22 %, and its RMS error 0.39 to 0.49";

std::vector<Method> methods() {
  std::vector<Method> all = methods_with_friction(collapse(dam), dam.column_height, plate,
                                                  {{"mpm_apic", finest("80 across", 29.3)},
                                                   {"mpm_xpic", finest("80 across", 22.8)},
                                                   {"sph_delta", finest("40 across", 22.4)},
                                                   {"sph_shifted", finest("40 across", 23.1)},
                                                   {"sph_corrected", finest("40 across", 26.0)}});
  for (Method& method : all)
    if (method.family == Family::mpm)
      method.tolerance.exceptions = {{"Martin & Moyce 1952, half-full slab", 0.35, of_sheet},
                                     {"Martin & Moyce 1952, with the best time shift, half-full slab", 0.35, of_sheet}};
  return all;
}

}  // namespace

Case vnv::the_case() {
  Case declared = beside_fronts(
      "Square dam break of Martin & Moyce",
      "A column of water 2.25 in square collapses from t = 0; L = l / l0 and T = t sqrt(g h0) / l0. From T = 1 to the "
      "end of the data, the front is compared with that of Martin & Moyce (1952), whose paper diaphragm is released by "
      "a pulse of current, and with that of Lobovský et al. (2014), who draw up a gate; the residual height at the "
      "back wall is compared with that of Martin & Moyce. Each comparison is made without a time shift and with the "
      "shift that fits best, at most 0.3 in T, the uncertainty of the time origins; that shift is a value of its own. "
      "The tank is 6 l0 long: the data end at L = 5.0, where a front that is early by 0.3 in T has not yet reached the "
      "wall. Surface tension is not modelled, and friction only by mpm_apic_friction.",
      dam, 6.3);
  declared.methods = methods();
  return declared;
}
