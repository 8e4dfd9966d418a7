#pragma once
/// Work-precision diagrams of the two channel flows: each method over resolutions and time steps, from rest to 1 s, and
/// the points of Sun et al. and of other codes.

#include "vnv/flows/start_up.hpp"
#include "vnv/studies/run_time.hpp"

#include <array>

namespace touchstone::vnv::channel {

/// What limits the time step of a method in a channel.
struct StepLimits {
  double acoustic;         // critical step times sound speed over `length`
  double viscous = 0.125;  // times length² over kinematic viscosity (Morris, Fox & Zhu 1997)
  double fraction = 0.8;   // of the smaller of both: the longest step taken
};

/// How many particle-steps a run with the longest step may have to belong to a suite; with a shorter one, a tenth.
struct Effort {
  double report, nightly;
};

/// Levels of the material point method: `cells` across the gap, 1 and 4 points in each, and the critical steps of both
/// as cells over sound speed.
std::vector<Level> mpm_run_time_levels(const std::vector<int>& cells, const std::array<double, 2>& acoustic,
                                       Effort effort);

/// Levels of smoothed particle hydrodynamics: `particles` across the gap, smoothing length in spacings.
std::vector<Level> sph_run_time_levels(const std::vector<int>& particles, double smoothing, StepLimits limits,
                                       Effort effort);

/// Error per particle at 1 s, and the errors to which CPU times are reported.
WorkDiagram work_diagram();

/// Tables 3 and 4 of Sun et al. as points: T_p times the steps to 1 s.
std::vector<WorkPoint> published_work(const std::string& flow);

/// Other codes, measured on another machine.
std::vector<WorkPoint> peers_in_poiseuille_flow();

/// One entry a method; the claims by its name, or else by "MPM" or "SPH".
template <class SceneOfChannel>
std::vector<Method> run_time_methods(const SceneOfChannel& scene,
                                     const std::map<std::string, std::vector<Claim>>& claims) {
  const std::vector<int> cells = {4, 6, 8, 10, 12, 16, 20, 28, 40, 80}, across = {10, 14, 20, 28, 40, 80};
  // With one particle per cell 1.11 lasts for 2000 steps; an even lattice of them bears 1 by its eigenvalues, and in
  // 28 and 40 cells a step of 1 cell over the sound speed diverged within 0.08 s.
  const Effort of_mpm{.report = 1.2e8, .nightly = 4e8}, of_sph{.report = 2e7, .nightly = 5e7};
  const std::vector<Level> mpm = mpm_run_time_levels(cells, {1, 1.41}, of_mpm),
                           affine = mpm_run_time_levels(cells, {0.9, 0.9}, of_mpm),
                           printed = sph_run_time_levels(across, 1.2, {.acoustic = 0.73, .fraction = 0.4}, of_sph),
                           regularised = sph_run_time_levels(across, 1, {.acoustic = 2.22}, of_sph),
                           one_evaluation = sph_run_time_levels(across, 1, {.acoustic = 0.8}, of_sph);
  const auto method = [&](Family family, const std::string& name, const std::string& description, auto run,
                          const std::vector<Level>& levels) -> Method {
    const auto of_it = claims.find(name);
    return {.name = name,
            .family = family,
            .description = description,
            .run = std::move(run),
            .levels = levels,
            .claims = of_it == claims.end() ? claims.at(family == Family::mpm ? "MPM" : "SPH") : of_it->second,
            .relative_cost = 30};
  };
  return {
      method(Family::mpm, "mpm", mpm_words + moving_words, mpm_with<mpm::PrescribedMotion>(scene), mpm),
      method(Family::mpm, "mpm_reset", mpm_words + reset_words, mpm_with<mpm::VelocityReset>(scene), mpm),
      method(Family::mpm, "mpm_float", mpm_words + moving_words + float_words,
             mpm_with<mpm::PrescribedMotion, float>(scene), mpm),
      method(Family::mpm, "mpm_affine", affine_words, mpm_affine(scene), affine),
      method(Family::sph, "sph", sph_printed_words + conservative_words, sph_as_printed(scene), printed),
      method(Family::sph, "sph_difference", sph_printed_words + difference_words,
             sph_as_printed<sph::PressureDifference>(scene), printed),
      method(Family::sph, "sph_regularised_float", sph_regularised_words + " Sums over pairs in single precision.",
             sph_with_transport_velocity<KickDriftKick, float>(scene), regularised),
      method(Family::sph, "sph_one_evaluation", sph_regularised_words + one_evaluation_words,
             sph_with_transport_velocity<AdamsBashforth>(scene), one_evaluation),
      method(Family::sph, "sph_regularised", sph_regularised_words, sph_with_transport_velocity(scene), regularised)};
}

/// The case of a flow: `exact` is its truth, `elsewhere` what others measured of it.
template <class SceneOfChannel>
Case error_against_run_time_in(const SceneOfChannel& scene, const Truth& exact, std::vector<WorkPoint> elsewhere,
                               const std::map<std::string, std::vector<Claim>>& claims) {
  return {
      .times = {1},
      .measurements = {norms_of("v_x, per particle", by_particles, exact)},
      .findings = {prices(work_diagram(), 1)},
      .repeats = {.budget = 3, .most = 7, .longest = 0.2},
      .methods = run_time_methods(scene, claims),
      .plots = {error_against_run_time(work_diagram(), 1, std::move(elsewhere))},
  };
}

}  // namespace touchstone::vnv::channel
