#pragma once
/// Samples of flows, as tests make them.

#include "vnv/flows/flow.hpp"

namespace touchstone::vnv::doors {

/// Gives rows the exact fields of a flow at their time; those that are not known exactly stay as they are.
inline void set_exact_fields(const Flow& flow, Samples& s) {
  for (const Exact& exact : flow.exact) {
    const FieldTruth truth = exact.with({});
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      const Vec2 value = truth(s.x.col(p), s.time);
      if (exact.field == "velocity")
        s.v.col(p) = value;
      else
        s.pressure[p] = value.x();
    }
  }
}

}  // namespace touchstone::vnv::doors
