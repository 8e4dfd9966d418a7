#include "solvers/sph/plain/plain.hpp"

#include "solvers/forces/uniform.hpp"
#include "solvers/integrators/adams_bashforth.hpp"
#include "solvers/sph/free_surface/diffusion/antuono.hpp"
#include "solvers/sph/free_surface/gradients/bonet_lok.hpp"
#include "solvers/sph/free_surface/shifting/tangential.hpp"
#include "solvers/sph/kernels/cubic_spline.hpp"
#include "solvers/sph/kernels/quintic_spline.hpp"
#include "solvers/sph/kernels/wendland_c2.hpp"
#include "solvers/sph/printed/printed.hpp"
#include "solvers/sph/terms/artificial_viscosity.hpp"
#include "solvers/sph/terms/bonet_lok_pressure.hpp"
#include "solvers/sph/terms/laminar_viscosity.hpp"
#include "solvers/sph/terms/monaghan_cleary_viscosity.hpp"
#include "solvers/sph/terms/morris_viscosity.hpp"
#include "solvers/sph/terms/pressure.hpp"
#include "solvers/sph/terms/pressure_difference.hpp"
#include "solvers/testing.hpp"
#include "solvers/walls/free_slip.hpp"

#include <random>

namespace touchstone::sph {
namespace {

constexpr double spacing = 0.05, c = 10, mu = 20;  // m, m/s, Pa s
constexpr Settings settings_with(double ratio) {
  return {.spacing = spacing, .smoothing_length = ratio * spacing, .time_step = 1e-3};
}

/// Fluid that moves unevenly, compressed unevenly, on a disturbed lattice that fills a part of its box, between walls
/// or periodic boundaries.
Scene<Newtonian, ForceField> random_scene(unsigned seed, double filled) {
  std::mt19937 dice(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(dice()) / 4294967296;
  };
  const auto any_wall = [&]() -> WallVelocity {
    if (dice() % 2 == 0) return free_slip();
    return no_slip({between(-0.5, 0.5), 0});
  };
  const Vec2 size(between(0.55, 0.75), between(0.55, 0.75));
  Scene<Newtonian, ForceField> scene{
      .domain = {.box = {.high = size}, .periodic_x = dice() % 2 == 0, .periodic_y = filled == 1 && dice() % 2 == 0},
      .fluid = oil,
      .filled = {.high = {filled * size.x(), filled * size.y()}}};
  scene.body_force.at = [=](const Vec2& x, double) -> Vec2 {
    return {std::sin(2 * std::numbers::pi * x.y() / size.y()), -1};
  };
  if (!scene.domain.periodic_x) scene.walls = {left_at(0, free_slip()), right_at(size.x(), any_wall())};
  if (!scene.domain.periodic_y) {
    scene.walls.push_back(floor_at(0, any_wall()));
    scene.walls.push_back(ceiling_at(size.y(), any_wall()));
  }
  const Vec2 stretch(between(-3, 3), between(-3, 3));
  scene.start.velocity = [=](const Vec2& x) -> Vec2 { return {stretch.x() * x.y(), stretch.y() * (x.x() - 0.3)}; };
  scene.start.pressure = [=](const Vec2& x) { return 300 * std::sin(9 * x.x()) + 100 * stretch.x() * x.y(); };
  scene.start.places = [seed](const Vectors& lattice) -> Vectors {
    std::mt19937 more(seed + 1000);
    Vectors places = lattice;
    for (double& x : places.reshaped()) x += 0.3 * spacing * (static_cast<double>(more()) / 4294967296 - 0.5);
    return places;
  };
  return scene;
}

/// Compares all that particles have, over so many steps of several scenes. `fast` and `plain` make solvers of a scene.
template <class Fast, class Plain>
void expect_same(int steps, double filled, const Fast& fast, const Plain& plain) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const auto scene = random_scene(seed, filled);
    auto one = fast(scene);
    auto other = plain(scene);
    for (int k = 0; k < steps; ++k) one.step(), other.step();
    const Samples a = one.samples(), b = other.samples();
    const auto expect_near = [](const char* what, const auto& x, const auto& y) {
      EXPECT_LE((x - y).abs().maxCoeff(), 1e-10 * y.abs().maxCoeff()) << what;
    };
    expect_near("place", a.x.array(), b.x.array());
    expect_near("velocity", a.v.array(), b.v.array());
    expect_near("density", a.density, b.density);
  }
}

template <class Kernel, class Integrator, class Left, class Terms>
void expect_printed_as_plain(double ratio, const Terms& terms) {
  const Settings settings = settings_with(ratio);
  expect_same(
      31, 1, [&](const auto& scene) { return printed<Kernel, Integrator, double, Left>(scene, settings, terms); },
      [&](const auto& scene) {
        using SceneOfRun = std::remove_cvref_t<decltype(scene)>;
        return PlainConfined<Kernel, Integrator, Left, decltype(SceneOfRun::fluid), decltype(SceneOfRun::body_force),
                             Terms>(scene, settings, terms);
      });
}
template <class Kernel, class Integrator, class Left, class Terms>
void expect_transport_as_plain(double ratio, const Terms& terms) {
  const Settings settings = settings_with(ratio);
  expect_same(
      31, 1,
      [&](const auto& scene) { return transport_velocity<Kernel, Integrator, double, Left>(scene, settings, terms); },
      [&](const auto& scene) {
        using SceneOfRun = std::remove_cvref_t<decltype(scene)>;
        return PlainConfined<Kernel, Integrator, Left, decltype(SceneOfRun::fluid), decltype(SceneOfRun::body_force),
                             Terms>(scene, settings, terms);
      });
}
template <class Kernel, class Integrator = KickDriftKick, class Terms, class PartsOfMethod>
void expect_free_surface_as_plain(double ratio, const Terms& terms, const PartsOfMethod& parts) {
  const Settings settings = settings_with(ratio);
  expect_same(
      12, 0.7, [&](const auto& scene) { return free_surface<Kernel, Integrator>(scene, settings, terms, parts); },
      [&](const auto& scene) {
        using SceneOfRun = std::remove_cvref_t<decltype(scene)>;
        return PlainFreeSurface<Kernel, Integrator, decltype(SceneOfRun::fluid), decltype(SceneOfRun::body_force),
                                Terms, PartsOfMethod>(scene, settings, terms, parts);
      });
}

// Each kernel, integrator, term and part in turn with others.

TEST(PlainSph, IsWhatPrintedSphDoes) {
  expect_printed_as_plain<CubicSpline, PredictorCorrector, Without<Repulsion, BackgroundPressure, VolumeConstraint>>(
      1, momentum(Pressure{}, LaminarViscosity{.nu = mu / 1000, .eta = 0.1 * spacing}));
  expect_printed_as_plain<WendlandC2, KickDriftKick,
                          Without<Repulsion, BackgroundPressure, VolumeConstraint, DensityReinitialisation>>(
      1.3, momentum(PressureSum{}, MorrisViscosity{mu}));
}

TEST(PlainSph, IsWhatSphWithATransportVelocityDoes) {
  expect_transport_as_plain<QuinticSpline, KickDriftKick, Without<DensityReinitialisation>>(
      1, momentum(PressureDifference{}, MorrisViscosity{mu}));
  expect_transport_as_plain<WendlandC2, PredictorCorrector, Without<DensityReinitialisation, DriftMomentum>>(
      1.3, momentum(PressureDifference{}, MonaghanClearyViscosity{.mu = mu}));
  expect_transport_as_plain<CubicSpline, AdamsBashforth, Without<DensityReinitialisation, BackgroundPressure>>(
      1.2, momentum(Pressure{}, MonaghanClearyViscosity{.mu = mu}));
}

template <class Kernel, class Integrator>
void expect_second_order_as_plain(double ratio) {
  const Settings settings = settings_with(ratio);
  expect_same(
      20, 1, [&](const auto& scene) { return second_order<Kernel, Integrator>(scene, settings); },
      [&](const auto& scene) {
        using SceneOfRun = std::remove_cvref_t<decltype(scene)>;
        return PlainSecondOrder<Kernel, Integrator, decltype(SceneOfRun::fluid), decltype(SceneOfRun::body_force)>(
            scene, settings);
      });
}

TEST(PlainSph, IsWhatSphOfSecondOrderDoes) {
  expect_second_order_as_plain<WendlandC2, AdamsBashforth>(1.3);
  expect_second_order_as_plain<CubicSpline, PredictorCorrector>(1.4);
}

TEST(PlainSph, IsWhatSphForFreeSurfacesDoes) {
  const auto diffusion = [](double ratio) { return Antuono{.sound_speed = c, .h = ratio * spacing}; };
  const auto artificial = [](double ratio) {
    return momentum(ArtificialViscosity{.alpha = 0.05, .sound_speed = c, .h = ratio * spacing});
  };
  expect_free_surface_as_plain<WendlandC2>(2, artificial(2), Parts(PressureSum{}, diffusion(2)));
  expect_free_surface_as_plain<CubicSpline, PredictorCorrector>(1.5, momentum(MorrisViscosity{mu}),
                                                                Parts(PressureSum{}));
  expect_free_surface_as_plain<QuinticSpline>(1.2, momentum(MonaghanClearyViscosity{.mu = mu}),
                                              Parts(PressureDifference{}, diffusion(1.2), BonetLok{}));
  expect_free_surface_as_plain<WendlandC2>(2, momentum(MonaghanClearyViscosity{.mu = mu}),
                                           Parts(BonetLokPressure{}, diffusion(2), BonetLok{}));
  expect_free_surface_as_plain<WendlandC2>(
      2, artificial(2), Parts(PressureSum{}, diffusion(2), PlainGradient{}, TangentialShifting{spacing}));
  expect_free_surface_as_plain<CubicSpline>(
      1.5, momentum(MonaghanClearyViscosity{.mu = mu}),
      Parts(BonetLokPressure{}, NoDiffusion{}, BonetLok{}, TangentialShifting{spacing}));
}

}  // namespace
}  // namespace touchstone::sph
