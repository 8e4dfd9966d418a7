#pragma once
/// What BEFORE and AFTER are: records that were written before, or builds whose programs can be run.

#include "vnv/gate/comparison.hpp"
#include "vnv/gate/gate.hpp"
#include "vnv/programs/programs.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <optional>
#include <ostream>
#include <utility>

namespace touchstone::gate {

/// The program of one case, with the methods that a suite runs.
struct Program {
  std::string case_name;
  std::filesystem::path file{}, data{};  // the program, and the folder of data that it reads
  std::vector<std::string> methods{};
  bool is_timed = false;  // what it judges is time
};

/// A build folder, with the sources it was made of.
struct Build {
  std::filesystem::path folder, source;
  std::vector<Program> programs{};
};

/// What a build folder was configured with, by the name of a variable; empty if it does not say.
std::string configured(const std::filesystem::path& folder, const std::string& name);

/// Revisions of a repository, built in folders that are gone with this. All are built in one folder, one after another,
/// so that a later one compiles only what differs.
class Revisions {
 public:
  explicit Revisions(std::filesystem::path repository) : repository_(std::move(repository)) {}
  ~Revisions() { forget_source(); }
  Revisions(const Revisions&) = delete;
  Revisions& operator=(const Revisions&) = delete;

  /// Checks a commit out beside the repository's own work tree and builds the programs of the chosen cases, all if none
  /// is chosen. Throws BadInput with the end of what the compiler said if they cannot be built.
  Build build(const std::string& commit, const Choice& choice, std::ostream& log);

 private:
  std::filesystem::path source() const { return scratch_ / "source"; }
  std::filesystem::path folder() const { return source() / "build"; }  // as in a clone: see CMakeLists.txt on ccache
  void check_out(const std::string& commit) const;
  void run(const programs::Words& words, const std::string& what) const;
  void forget_source() const;

  programs::ScratchFolder scratch_;
  std::filesystem::path repository_;
};

/// One side of a comparison: records, or a build.
struct Source {
  std::string name;  // as it was asked for
  Records records{};
  std::optional<Build> build{};
};

/// What a name means: a file is a record, a folder with CMakeCache.txt and vnv/ a build, any other folder one of
/// records, and whatever is neither a revision of the repository around the current folder. Throws BadInput for what is
/// none of these, for a folder without records, for records that cannot be read, and for those of several suites.
Source open_source(const std::string& name, const Choice& choice, Revisions& revisions, std::ostream& log);

/// Whether two builds would find the same in a case: its program has the same bytes in both, or else all compiled files
/// of it and of the libraries that both builds have, and the data that it may read are the same. The file that holds
/// the revision is left out: it describes where a record was made and the compiler writes it into its code, so that
/// programs of two revisions never have the same bytes. Names of the folders of a build and its sources count for
/// nothing where they are as long in both. Whatever cannot be distinguished from a change is one: then both are run.
bool are_same_programs(const Build& before, const Build& after, const Program& program, const Program& other);

}  // namespace touchstone::gate
