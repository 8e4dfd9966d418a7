#pragma once
/// Verdict mutation: would each claim that holds be seen to fail?

#include "vnv/harness/assess.hpp"

#include <array>
#include <optional>

namespace touchstone::vnv {

/// What is done to what a claim reads: its value is moved just beyond its limit, is not a number, is not there, is that
/// of another level, or nothing measures its quantity.
enum class Mutation { beyond, no_number, missing, elsewhere, unmeasured };
constexpr auto words(Mutation) {
  return std::to_array<std::string_view>({"beyond", "nan", "missing", "elsewhere", "unmeasured"});
}

/// How many claims hold of a method, and how many mutations of each kind were tried and seen.
struct Mutations {
  long claims = 0;
  std::array<long, words(Mutation{}).size()> tried{}, seen{};
  std::vector<std::string> survivors{};
  std::optional<Record> failing{};  // of samples: as judged where the last of its claims failed
  double seconds = 0;               // of samples: spent on this after the runs

  /// "34 claims hold: beyond 34/34, nan 30/30, ..."
  std::string sentence() const;
};

/// Judges a method anew by the values that a record of it holds, and again for each claim that holds with what that one
/// reads mutated: nothing is run, all else is what judges a run. `beyond` is seen if the claim itself fails, the others
/// if the method does. An end is mutated by a run that did not end, an order by the error of one level and an ensemble
/// by all members, each by about the smallest factor that does it. Throws std::invalid_argument where the record,
/// unmutated, is not judged as it says.
Mutations mutate_record(const Case& declared, const Method& method, const Record& record, const Baselines& baselines,
                        const AcceptedClaims& accepted);

/// Runs a method and scales one field of all particles, of all levels together and, for claims that do not fail so, of
/// one level, before anything is measured: velocity, density, pressure, the position about the centre, what was
/// monitored or its time, steps, or what the run itself found; or leaves out particles at the bottom and the top. `beyond`
/// is seen if some field makes the claim fail, or, for a claim on ends, runs that do not end; `least` are lines that say
/// which one needs the smallest change.
Mutations mutate_samples(const std::string& case_name, const Case& declared, const Method& method, Suite suite,
                         const Baselines& baselines, std::vector<std::string>& least);

}  // namespace touchstone::vnv
