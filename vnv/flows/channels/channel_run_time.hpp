#pragma once
/// Error against run time in the two start-up flows of Sun et al.: all their methods, each keeping an acoustic Courant
/// number, and the points of Sun et al. and of other codes.

#include "vnv/flows/channels/channel_flow.hpp"
#include "vnv/flows/channels/start_up.hpp"

namespace touchstone::vnv::channel {

/// Tables 3 and 4 of Sun et al. as points: T_p times the steps to 1 s.
std::vector<WorkPoint> published_work(const std::string& flow);

/// Other codes, measured on another machine.
std::vector<WorkPoint> peers_in_poiseuille_flow();

/// The methods; the claims by name.
template <class SceneOfChannel>
std::vector<Method> run_time_methods(const SceneOfChannel& scene,
                                     const std::map<std::string, std::vector<Claim>>& claims) {
  constexpr double interval = 0.05;  // s
  const auto method = [&](std::string name, std::string words, Family family, double courant, auto solver) {
    return keeping_courant_number(courant, interval, scene, solver,
                                  {.name = std::move(name), .family = family, .description = std::move(words)});
  };
  // By 2 and 1.4 these become the largest steps that four points and one point per cell bear, 1.28 and 0.9 of a cell.
  std::vector<Method> all = {
      vnv::mpm_as_printed(scene, interval, 0.64),
      method("mpm_reset", mpm_words + reset_words, Family::mpm, 0.64,
             mpm_solver<mpm::VelocityReset, double, SceneOfChannel>),
      method("mpm_float", mpm_words + moving_words + float_words, Family::mpm, 0.64,
             mpm_solver<mpm::PrescribedMotion, float, SceneOfChannel>),
      vnv::mpm_affine(scene, interval),
      vnv::mpm_least_squares(scene, interval),
      vnv::sph_as_printed(scene, interval),
      method("sph_difference", sph_printed_words + difference_words, Family::sph, 0.25,
             sph_printed_solver<sph::PressureDifference, PredictorCorrector, SceneOfChannel>),
      sph_regularised(scene, interval),
      method("sph_regularised_float", sph_regularised_words + " Sums over pairs in single precision.", Family::sph, 0.9,
             sph_regularised_solver<KickDriftKick, float, SceneOfChannel>),
      method("sph_one_evaluation", sph_regularised_words + one_evaluation_words, Family::sph, 0.32,
             sph_regularised_solver<AdamsBashforth, double, SceneOfChannel>),
      vnv::sph_second_order(scene, interval)};
  for (Method& one : all)
    if (const auto of_it = claims.find(one.name); of_it != claims.end()) one.claims_of_work = of_it->second;
  return all;
}

/// Error per particle at 0.1 and 1 s: at 1 s, when the profile is a parabola or a straight line, fits of second degree
/// are exact.
inline WorkStudy start_up_study(double fastest) {
  return {.error = l2, .times = {0.1, 1}, .length = H, .largest_speed = fastest};
}

/// The case of a flow, with a scene of the body force that it has.
template <class Force>
Case error_against_run_time_in(std::string title, std::string description, const Flow& flow, const WorkStudy& study,
                               std::vector<WorkPoint> elsewhere = {},
                               const std::map<std::string, std::vector<Claim>>& claims = {}) {
  return with_work({.title = std::move(title),
                    .description = std::move(description),
                    .times = study.times,
                    .measurements = {norms_of("v_x, per particle", by_particles, flow.along_x())},
                    .repeats = {.budget = 3, .most = 7, .longest = 0.2},
                    .methods = run_time_methods(scene_of<Newtonian, Force>(flow), claims)},
                   study, std::move(elsewhere));
}

}  // namespace touchstone::vnv::channel
