#pragma once
/// What cases of a rotating square patch share (vnv/flows/rotating_patch.cpp).

#include "reference/rotating_patch.hpp"
#include "vnv/flows/flow.hpp"
#include "vnv/measures/roughness.hpp"
#include "vnv/methods/free_surface_methods.hpp"

namespace touchstone::vnv::patch {

inline constexpr double L = 1;  // m  where nothing else is set

/// Columns of what is monitored.
enum Monitored : std::size_t { momentum_x, momentum_y, angular_momentum, energy, longer, shorter, middle };

inline const Quantity drift{"largest change of momentum over m omega L", "", Kind::invariant},
    angular_momentum_error{"largest relative change of angular momentum", "%", Kind::invariant},
    loss{"relative loss of kinetic energy", "%", Kind::invariant},
    asymmetry{"relative difference of the half-axes from second moments", "%", Kind::invariant};

/// The last of them only where it is asked for.
Measurement conservation_errors(const reference::RotatingPatch& patch,
                                std::function<bool(const Level&)> asks_for_asymmetry);

inline Measurement roughness_of_pressure(const reference::RotatingPatch& patch) {
  return roughness_of("pressure", pressure, "rho omega² L²", patch.rho * patch.omega * patch.omega * patch.L * patch.L);
}

/// The methods that run it.
inline std::vector<Method> methods_on(const Scene<Tait>& scene) {
  constexpr double output_interval = 0.1;  // s  of which every step divides the times
  return {mpm_as_printed(scene, output_interval, 0.4), mpm_apic(scene, output_interval),
          sph_delta(scene, output_interval), sph_shifted(scene, output_interval)};
}

}  // namespace touchstone::vnv::patch
