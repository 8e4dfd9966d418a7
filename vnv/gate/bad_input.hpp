#pragma once
#include <stdexcept>

namespace touchstone::gate {

/// What the caller asked for cannot be compared; one line says why.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace touchstone::gate
