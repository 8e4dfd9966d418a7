#pragma once
/// All cases of a build folder, as their programs describe themselves.

#include "vnv/programs/programs.hpp"
#include "vnv/record/description.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace touchstone::vnv::command {

using programs::Words;

/// Where programs are, and what they read.
struct Build {
  std::filesystem::path folder{};
  std::filesystem::path data{};  // empty: that of the sources

  std::filesystem::path program(const std::string& case_name) const { return folder / "vnv" / case_name; }
  /// The program of a case with arguments.
  Words call(const std::string& case_name, const Words& arguments) const;
  /// What is run leaves its records and pages in the build folder, that of an installed program where its user is.
  std::filesystem::path results() const { return is_installed() ? "" : folder; }
  std::filesystem::path records(const std::string& suite) const { return results() / "records" / suite; }

  /// What is named, else that of the sources.
  std::filesystem::path data_in_use() const;

  /// Installed, programs lie as in a build folder, and their data beside them.
  std::filesystem::path installed_data() const { return folder / "data"; }
  bool is_installed() const {
    return std::filesystem::is_directory(installed_data()) && !std::filesystem::exists(folder / "CMakeCache.txt");
  }
};

/// One method of one case. It points into a catalogue, which lives longer.
struct Chosen {
  const Description* of;
  const MethodDescription* method;

  std::string name() const { return of->name + "." + method->name; }  // "poiseuille.mpm"
};

struct Catalogue {
  std::vector<Description> cases;      // by name
  std::vector<std::string> not_built;  // cases that were meant and have no program

  std::vector<Chosen> methods() const;
};

/// Asks the program of each case that the patterns may choose. Throws std::runtime_error for a folder that is no build
/// folder, and for a program that cannot say what it is.
Catalogue read_catalogue(const Build& build, const std::vector<std::string>& patterns = {});

/// The methods that the patterns choose (see patterns.hpp) and the suite, if one is given, runs. Throws
/// std::invalid_argument where that is none.
std::vector<Chosen> choose(const Catalogue& catalogue, const std::vector<std::string>& patterns,
                           const std::string& suite = "");

/// The same, where each case that was meant has to be there: throws std::invalid_argument naming those that are not
/// built, so that nothing is green for want of a program.
std::vector<Chosen> choose_all(const Catalogue& catalogue, const std::vector<std::string>& patterns,
                               const std::string& suite);

}  // namespace touchstone::vnv::command
