#include "vnv/flows/formulas/formulas.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_bessel.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace touchstone::vnv::formulas {
namespace {

/// A value of GSL, NaN where it has none: its own handler of errors would end the program.
template <auto f, class... Arguments>
double of_gsl(Arguments... arguments) {
  gsl_sf_result result{};
  gsl_error_handler_t* const before = gsl_set_error_handler_off();
  const int status = f(arguments..., &result);
  gsl_set_error_handler(before);
  return status == 0 ? result.val : NAN;
}

double jn(double order, double x) {
  constexpr double most = 1000;
  if (order != std::floor(order) || std::abs(order) > most) return NAN;
  return of_gsl<gsl_sf_bessel_Jn_e>(static_cast<int>(order), x);
}

/// A parser that knows our functions.
mu::Parser parser() {
  mu::Parser made;
  made.DefineConst("pi", std::numbers::pi);
  made.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
  made.DefineFun("erfc", static_cast<double (*)(double)>(std::erfc));
  made.DefineFun("j0", of_gsl<gsl_sf_bessel_J0_e, double>);
  made.DefineFun("j1", of_gsl<gsl_sf_bessel_J1_e, double>);
  made.DefineFun("jn", jn);
  made.DefineFun("y0", of_gsl<gsl_sf_bessel_Y0_e, double>);
  made.DefineFun("y1", of_gsl<gsl_sf_bessel_Y1_e, double>);
  made.DefineFun("i0", of_gsl<gsl_sf_bessel_I0_e, double>);
  made.DefineFun("i1", of_gsl<gsl_sf_bessel_I1_e, double>);
  made.DefineFun("k0", of_gsl<gsl_sf_bessel_K0_e, double>);
  made.DefineFun("k1", of_gsl<gsl_sf_bessel_K1_e, double>);
  return made;
}

[[noreturn]] void refuse(const Definition& one, const mu::ParserError& error) {
  std::string at = one.where;
  if (one.column > 0 && error.GetPos() >= 0) at += fmt::format(":{}", one.column + error.GetPos());
  throw std::invalid_argument(fmt::format("{}: {} = \"{}\": {}", at, one.name, one.text, error.GetMsg()));
}

double value_of_table(void* table, double at) { return (*static_cast<std::function<double(double)>*>(table))(at); }

const std::set<std::string> places_and_time{"x", "y", "t"};

}  // namespace

void require_name(const std::string& name, const std::string& where) {
  try {
    double none = 0;
    mu::Parser of_name = parser();
    if (places_and_time.contains(name) || of_name.GetFunDef().contains(name) || of_name.GetConst().contains(name))
      throw mu::ParserError("known");
    of_name.DefineVar(name, &none);
    of_name.SetExpr(name);
    of_name.Eval();
  } catch (const mu::ParserError&) {
    throw std::invalid_argument(fmt::format(
        "{}: the name '{}', expected letters, digits and _ that stand for nothing else, such as x, t or a function",
        where, name));
  }
}

struct Formulas::Program {
  double x = 0, y = 0, t = 0;
  Numbers numbers;      // parsers read them here
  Functions functions;  // and call them here
  struct Step {
    std::string name;
    mu::Parser parser;
    bool is_constant;
    double value = 0;
  };
  std::vector<Step> steps{};
  std::vector<std::size_t> wanted{};  // steps
  std::vector<double> values{};

  void add(const Definition& one) {
    Step step{one.name, parser(), true};
    try {
      for (const auto& [name, at] : {std::pair("x", &x), {"y", &y}, {"t", &t}}) step.parser.DefineVar(name, at);
      for (auto& [name, number] : numbers) step.parser.DefineVar(name, &number);
      for (Step& before : steps) step.parser.DefineVar(before.name, &before.value);
      for (auto& [name, function] : functions) step.parser.DefineFunUserData(name, value_of_table, &function);
      step.parser.SetExpr(one.text);
      step.value = step.parser.Eval();
      for (const auto& [name, at] : step.parser.GetUsedVar()) {
        const auto before = std::ranges::find(steps, name, &Step::name);
        step.is_constant &= before == steps.end() ? !places_and_time.contains(name) : before->is_constant;
      }
    } catch (const mu::ParserError& error) {
      refuse(one, error);
    }
    steps.push_back(std::move(step));
  }
};

Formulas::Formulas(const std::vector<Definition>& definitions, const std::vector<std::string>& wanted,
                   const Numbers& numbers, const Functions& functions)
    : program_(std::make_shared<Program>()) {
  Program& all = *program_;
  all.numbers = numbers;
  all.functions = functions;
  all.steps.reserve(definitions.size());  // parsers hold the places of values
  for (const Definition& one : definitions) all.add(one);
  std::set<std::string> needed(wanted.begin(), wanted.end());
  for (auto step = all.steps.rbegin(); step != all.steps.rend(); ++step)
    if (needed.contains(step->name))
      for (const auto& [name, at] : step->parser.GetUsedVar()) needed.insert(name);
  for (Program::Step& step : all.steps) step.is_constant |= !needed.contains(step.name);
  for (const std::string& name : wanted) {
    const auto step = std::ranges::find(all.steps, name, &Program::Step::name);
    if (step == all.steps.end()) throw std::logic_error("no formula of " + name);
    all.wanted.push_back(static_cast<std::size_t>(step - all.steps.begin()));
  }
  all.values.resize(wanted.size());
}

std::span<const double> Formulas::operator()(double x, double y, double t) const {
  Program& all = *program_;
  all.x = x, all.y = y, all.t = t;
  for (Program::Step& step : all.steps)
    if (!step.is_constant) step.value = step.parser.Eval();
  for (std::size_t k = 0; k < all.wanted.size(); ++k) all.values[k] = all.steps[all.wanted[k]].value;
  return all.values;
}

bool Formulas::are_constant() const {
  return std::ranges::all_of(program_->wanted, [&](std::size_t k) { return program_->steps[k].is_constant; });
}

}  // namespace touchstone::vnv::formulas
