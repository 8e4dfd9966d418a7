#pragma once
/// Scenes that no method is made for, each with the ending that is expected of a method, declared beforehand.

#include "vnv/case.hpp"

namespace touchstone::vnv {

/// How a run ends: refused when it is set up, with one line; diverged, and said so; stable to its end; or accurate,
/// too.
enum class Ending { refused, diverged, stable, accurate };
std::string_view name_of(Ending ending);

/// A scene for one method.
struct Extreme {
  std::string name;
  MakeSimulation make;
  double end;                                     // s
  std::function<double(const Samples&)> error{};  // %  at the end; none where nothing exact is known
  double accurate_within = 0;                     // %
  Ending declared = Ending::stable;
  bool in_acceptance = true;
  Stepping stepping = Stepping::adaptive;
};

inline const Quantity ends_as_declared{"outcome as declared", "", Kind::value, Better::larger};

/// A method and what it is to meet: each scene a level, the claim that it ends as declared, a table of endings and
/// pictures of those that are drawn.
Method meeting(Method method, const std::vector<Extreme>& extremes);

/// The table and the pictures; they are the same for all methods of a case.
Plot endings(std::vector<std::string> drawn);

}  // namespace touchstone::vnv
