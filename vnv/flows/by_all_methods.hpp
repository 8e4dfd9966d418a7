#pragma once
/// A flow as a case by itself: what is measured and claimed of any code, of our own methods.

#include "vnv/flows/flow.hpp"
#include "vnv/methods/free_surface_methods.hpp"

#include <cmath>

namespace touchstone::vnv {

/// The longest interval [s] of which all times of a flow are multiples, and of which steps of a method are a part.
inline double interval_of(const Flow& flow) {
  const std::vector<double>& times = flow.judged.times;
  for (int parts = 1; parts < 1000; ++parts) {
    const double interval = times.front() / parts;
    const auto is_multiple = [&](double t) { return std::abs(t / interval - std::round(t / interval)) < 1e-9; };
    if (std::ranges::all_of(times, is_multiple)) return interval;
  }
  throw std::invalid_argument(flow.name + ": no interval divides all of its times, expected one by which methods step");
}

/// The methods that run a scene with a free surface.
template <class AnyScene>
std::vector<Method> free_surface_methods(const AnyScene& scene, double output_interval,
                                         const SphChoice& of_delta = {}) {
  return {mpm_as_printed(scene, output_interval, 0.4), mpm_affine(scene, output_interval),
          mpm_apic(scene, output_interval),            mpm_xpic(scene, output_interval),
          sph_as_printed(scene, output_interval, 0.2), sph_delta(scene, output_interval, of_delta)};
}

/// The methods that know the fluid of a flow, its force and whether its surface is free: what a flow has not is
/// compiled into none of them.
inline std::vector<Method> methods_for(const Flow& flow) {
  const double interval = interval_of(flow);
  const auto filling = [&](const auto& scene) -> std::vector<Method> {
    return {mpm_as_printed(scene, interval), mpm_affine(scene, interval),
            mpm_least_squares(scene, interval), sph_as_printed(scene, interval),
            sph_transport_velocity(scene, interval), sph_second_order(scene, interval)};
  };
  const auto with_a_surface = [&](const auto& scene) -> std::vector<Method> {
    std::vector<Method> all = free_surface_methods(scene, interval);
    std::erase_if(all, [](const Method& method) { return method.name == "mpm_xpic"; });  // it costs most
    return all;
  };
  const bool is_uniform = !flow.drive.at && flow.drive.angular_frequency == 0,
             has_force = flow.drive.at || !flow.drive.amplitude.isZero(0), is_viscous = flow.fluid.viscosity > 0;
  if (flow.has_free_surface() || !is_viscous) {
    if (is_viscous) return with_a_surface(scene_of<Newtonian, Uniform>(flow));
    return has_force ? with_a_surface(scene_of<Tait, Uniform>(flow)) : with_a_surface(scene_of<Tait>(flow));
  }
  if (!has_force) return filling(scene_of<Newtonian>(flow));
  return is_uniform ? filling(scene_of<Newtonian, Uniform>(flow)) : filling(scene_of<Newtonian, ForceField>(flow));
}

/// At its published parameters, with 20 to 80 particles across; acceptance runs the first three resolutions.
inline Case by_all_methods(const Flow& flow) {
  Case declared = flow.judged;
  declared.title = flow.title();
  for (const Measured& one : flow.measured) declared.measurements.push_back(one.measurement);
  declared.claims.insert(declared.claims.end(), flow.aside.begin(), flow.aside.end());
  const double end = flow.judged.times.back();
  declared.methods = with_ladder(levels_across(flow.across, {{20, end, 0, end},
                                                             {28, end, 0, end},
                                                             {40, end, 0, end},
                                                             {56, 0, 0, end},
                                                             {80, 0, 0, end}}),
                                 methods_for(flow), {});
  for (Method& method : declared.methods)
    method.ladders.front().name = ladder_of_files;  // of which a flow claims an order
  return declared;
}

}  // namespace touchstone::vnv
