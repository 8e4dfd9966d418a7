#include "vnv/flows/squares/in_square.hpp"

namespace touchstone::vnv::flows {

void fill(Flow& flow, const VelocityWith& velocity_with, PressureTruth pressure, std::vector<Cause> causes) {
  const VelocityTruth velocity = velocity_with({});
  flow.filled = flow.domain.box;
  if (flow.across == 0) flow.across = flow.filled.size().minCoeff();
  flow.start.velocity = [velocity](const Vec2& x) { return velocity(x, 0); };
  if (pressure) flow.start.pressure = [pressure](const Vec2& x) { return pressure(x, 0); };
  flow.judged.claims = {is_consistent(l2_velocity)};
  flow.measured = {{{"velocity"}, velocity_errors(velocity)}};
  flow.exact = {{.field = "velocity",
                 .norms = {l2_velocity.name, linf_velocity.name},
                 .components = 2,
                 .causes = std::move(causes),
                 .with = velocity_with}};
}

Flow in_square(double side, const Newtonian& fluid, const VelocityWith& velocity_with, PressureTruth pressure,
               std::vector<Cause> causes) {
  Flow flow;
  flow.domain = {.box = {.high = {side, side}}, .periodic_x = true, .periodic_y = true};
  flow.fluid = fluid;
  fill(flow, velocity_with, std::move(pressure), std::move(causes));
  return flow;
}

void add_pressure(Flow& flow, const PressureWith& with, std::vector<Cause> causes) {
  flow.measured.push_back({{"pressure"}, pressure_errors(with({}))});
  flow.measured.push_back({{"pressure"}, part_of_exact_pressure(with({}), true)});
  flow.aside.push_back(has_its_pressure());
  flow.exact.push_back({.field = "pressure",
                        .norms = {l2_pressure.name},
                        .less_mean = true,
                        .causes = std::move(causes),
                        .with = [with](const Changes& by) -> FieldTruth {
                          return [truth = with(by)](const Vec2& x, double t) { return Vec2(truth(x, t), 0); };
                        }});
}

}  // namespace touchstone::vnv::flows
