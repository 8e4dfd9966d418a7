#pragma once
/// A flow that is chaotic, from many starts that differ by a hair. One run says nothing: another compiler has another.
/// What all of them are together is the method's, and is compared with the ensemble that was last accepted.

#include "vnv/case.hpp"
#include "vnv/judge/baselines.hpp"
#include "vnv/judge/distribution.hpp"
#include "vnv/studies/starts.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// How many starts there are, and how they differ.
struct Ensemble {
  int members = 16;
  double jitter = vnv::jitter;

  /// The starts as levels, each like `one` but for its name.
  std::vector<Level> levels(const Level& one) const {
    std::vector<Level> all;
    for (int k = 1; k <= members; ++k) {
      all.push_back(one);
      all.back().name = "start " + std::to_string(k);
    }
    return all;
  }

  /// A method from each of the starts; `method_on(scene)` makes it for a scene. Its levels are those of `one`.
  template <class AnyScene, class MethodOn>
  Method method(const AnyScene& scene, const Level& one, const MethodOn& method_on) const {
    Method method = method_on(scene);
    method.levels = levels(one);
    method.tolerance = {1, "a member of an ensemble: only the distribution is compared"};
    method.run = [=, *this](const Level& level, const Schedule& when) {
      return method_on(from_start(seed_of(level), jitter * level.spacing, scene)).run(level, when);
    };
    return method;
  }

 private:
  static unsigned seed_of(const Level& level) {
    const std::size_t digits = level.name.find_first_of("0123456789");
    return digits == std::string::npos ? 0 : static_cast<unsigned>(std::stoul(level.name.substr(digits)));
  }
};

/// One number of an ensemble beside that of the ensemble that was accepted.
struct EnsembleComparison {
  Quantity quantity;
  double time;  // s
  std::vector<double> members, accepted;
  double distance;  // in the unit of the quantity, of Wasserstein
  double p_value;   // of two ensembles of one distribution, by Anderson and Darling's test
};

/// Each number of a record's members, in the order of the record. Nothing is accepted where a baseline is missing.
std::vector<EnsembleComparison> compare_with_accepted(const Record& record, const Baselines& baselines);

/// Ensembles of one distribution are less alike once in so many comparisons.
inline constexpr double least_p_value = 1e-4;

}  // namespace touchstone::vnv
