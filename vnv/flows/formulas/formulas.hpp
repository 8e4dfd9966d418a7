#pragma once
/// Formulas of a place and a time, as a user writes them: muParser's operators and functions, and besides these pi,
/// erf, erfc and the Bessel functions j0, j1, jn(n, x), y0, y1, i0, i1, k0 and k1.

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace touchstone::vnv::formulas {

/// A name, the formula that it stands for, and where that is written: "flow.toml:12".
struct Definition {
  std::string name, text, where{};
  long column = 0;  // in that line, of the first character; 0: not known
};

using Numbers = std::map<std::string, double>;

/// Functions of one argument by their names, as those that a table gives.
using Functions = std::map<std::string, std::function<double(double)>>;

/// What may be written of x [m], y [m] and t [s], of numbers and of formulas that stand before.
///
/// Throws std::invalid_argument where a formula cannot be read or speaks of what is not there: where, the formula and
/// what was expected. Copies share what they compute with: not for two threads at once.
class Formulas {
 public:
  /// Of `definitions` the values of those named in `wanted` are computed; of the others what these need.
  Formulas(const std::vector<Definition>& definitions, const std::vector<std::string>& wanted, const Numbers& numbers,
           const Functions& functions = {});

  /// The values of those that are wanted, valid until the next call.
  std::span<const double> operator()(double x, double y, double t) const;

  /// Whether all that are wanted are the same everywhere and at all times.
  bool are_constant() const;

 private:
  struct Program;
  std::shared_ptr<Program> program_;
};

/// Throws std::invalid_argument unless a name is one that formulas may use and that means nothing else.
void require_name(const std::string& name, const std::string& where);

}  // namespace touchstone::vnv::formulas
