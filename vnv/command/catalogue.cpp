#include "vnv/command/catalogue.hpp"

#include "vnv/command/patterns.hpp"
#include "vnv/gate/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <stdexcept>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> case_names(const Build& build) {
  if (build.is_installed())
    throw std::invalid_argument(fmt::format(
        "{}: an installed copy, which has no cases; expected the file of a solver (.toml), or a build folder by --build",
        build.folder.string()));
  const fs::path file = build.folder / "vnv" / "cases.txt";
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error(fmt::format(
        "{}: cannot be read, expected the list of cases in a build folder; --build names one", file.string()));
  std::vector<std::string> names;
  for (std::string name; in >> name;) names.push_back(name);
  return names;
}

Description described_by(const Words& call) {
  const programs::CapturedOutput captured = programs::run_and_capture(call);
  const std::string source = fmt::format("{}", fmt::join(call, " "));
  if (!captured.ending.succeeded()) throw std::runtime_error(fmt::format("{}: {}", source, captured.complaint()));
  return description_in(captured.output, source);
}

/// By name, as the cases of the list are.
std::vector<std::string> chosen_cases(const std::vector<std::string>& patterns, const std::vector<std::string>& all) {
  if (patterns.empty()) return all;
  std::set<std::string> chosen;
  for (const std::string& pattern : patterns)
    for (std::string& name : possible_cases(pattern, all)) chosen.insert(std::move(name));
  return {chosen.begin(), chosen.end()};
}

std::vector<std::string> names_of(const std::vector<Chosen>& methods) {
  std::vector<std::string> names;
  for (const Chosen& one : methods) names.push_back(one.name());
  return names;
}

}  // namespace

Words Build::call(const std::string& case_name, const Words& arguments) const {
  Words words = {program(case_name).string()};
  if (!data.empty()) words.insert(words.end(), {"--data", data.string()});
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

fs::path Build::data_in_use() const {
  return data.empty() ? fs::path(gate::configured(folder, "CMAKE_HOME_DIRECTORY")) / "data" : data;
}

std::vector<Chosen> Catalogue::methods() const {
  std::vector<Chosen> all;
  for (const Description& one : cases)
    for (const MethodDescription& method : one.methods) all.push_back({&one, &method});
  return all;
}

Catalogue read_catalogue(const Build& build, const std::vector<std::string>& patterns) {
  Catalogue catalogue;
  for (const std::string& name : chosen_cases(patterns, case_names(build))) {
    if (fs::is_regular_file(build.program(name)))
      catalogue.cases.push_back(described_by(build.call(name, {"--describe"})));
    else
      catalogue.not_built.push_back(name);
  }
  return catalogue;
}

std::vector<Chosen> choose(const Catalogue& catalogue, const std::vector<std::string>& patterns,
                           const std::string& suite) {
  std::vector<Chosen> methods = catalogue.methods();
  const std::vector<std::string> expected = chosen_by(patterns, names_of(methods));
  std::erase_if(methods, [&](const Chosen& one) {
    return std::ranges::find(expected, one.name()) == expected.end() ||
           !(suite.empty() || one.method->is_run_in(suite));
  });
  if (methods.empty())
    throw std::invalid_argument(expected.empty()
                                    ? "no case is built; expected at least one: cmake --build BUILD"
                                    : fmt::format("{}: the suite {} runs none of it, expected at least one method",
                                                  fmt::join(expected, ", "), suite));
  return methods;
}

std::vector<Chosen> choose_all(const Catalogue& catalogue, const std::vector<std::string>& patterns,
                               const std::string& suite) {
  if (catalogue.not_built.empty()) return choose(catalogue, patterns, suite);
  const std::vector<std::string> built = names_of(catalogue.methods());
  for (const std::string& pattern : patterns)
    if (matches(pattern, built).empty() && !fits_a_case(pattern, catalogue.not_built))
      throw std::invalid_argument(
          fmt::format("no case fits '{}', nor does a method of those that are built; expected a case, CASE.METHOD, a "
                      "glob or a part of one, as `vnv list` shows them. Not built: {}",
                      pattern, fmt::join(catalogue.not_built, ", ")));
  throw std::invalid_argument(fmt::format("not built: {}; expected the program of each case: cmake --build BUILD",
                                          fmt::join(catalogue.not_built, ", ")));
}

}  // namespace touchstone::vnv::command
