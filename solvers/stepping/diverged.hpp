#pragma once
/// The one way in which a simulation may fail: with method, step, time, particle, place, quantity and value.

#include "solvers/fields.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace touchstone {

class Diverged : public std::runtime_error {
 public:
  struct Fault {
    long step;
    double time;  // s
    Eigen::Index particle;
    Vec2 place;            // m
    std::string quantity;  // such as "x [m]"
    double value;
    std::string expected;  // such as "inside the domain"
  };

  explicit Diverged(Fault f)
      : std::runtime_error(fmt::format(
            "diverged at step {}, t = {:.6g} s, particle {} at ({:.6g}, {:.6g}) m: {} = {:.6g}, expected {}", f.step,
            f.time, f.particle, f.place.x(), f.place.y(), f.quantity, f.value, f.expected)),
        fault(std::move(f)) {}

  const Fault fault;
};

}  // namespace touchstone
