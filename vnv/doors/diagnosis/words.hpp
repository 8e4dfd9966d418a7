#pragma once
/// What is said of a fit.

#include "vnv/doors/diagnosis/fit.hpp"
#include "vnv/record/diagnosis.hpp"

namespace touchstone::vnv::doors::diagnosis {

/// What is there besides it as noise is said with what is named, in words with the best.
Explanation explanation(const Fit& fit, const FieldVector& seen, double spacing, bool is_named, bool is_best = false);

/// What has no waves longer than some samples; its share is 1 where all waves are equally strong.
Explanation as_noise(const FieldVector& seen);

/// The best explanation, and the others that are named with it.
std::string in_words(const std::vector<Explanation>& explanations);

}  // namespace touchstone::vnv::doors::diagnosis
