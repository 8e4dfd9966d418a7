#include "vnv/doors/solver.hpp"

#include "vnv/doors/scene.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/harness/assess.hpp"
#include "vnv/judge/baselines.hpp"
#include "vnv/programs/progress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glob.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <span>
#include <sstream>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

namespace fs = std::filesystem;

/// What stands in the folder of a run besides its output; that of what the program says is `log_file`.
constexpr std::string_view scene_file = "scene.json", particles_file = "particles.csv", run_script = "run.sh",
                           log_file = "output.txt";

std::string name_of(const Solver& solver, double spacing) {
  return fmt::format("{:.4g}_across", solver.flow.across / spacing);
}

/// What a replacement field of the command stands for.
std::map<std::string, std::string> replacements(const Solver& solver, double spacing, const fs::path& folder) {
  std::map<std::string, std::string> all{{"spacing", fmt::format("{}", spacing)},
                                         {"across", fmt::format("{:.12g}", solver.flow.across / spacing)},
                                         {"until", fmt::format("{}", solver.times.back())},
                                         {"times", fmt::format("{}", fmt::join(solver.times, ","))},
                                         {"scene", (folder / scene_file).string()},
                                         {"particles", (folder / particles_file).string()},
                                         {"folder", folder.string()},
                                         {"here", solver.file.parent_path().string()}};
  std::vector<std::string> parameters;
  for (const Parameter& p : solver.flow.parameters) {
    all.emplace(p.name, fmt::format("{}", p.value));
    parameters.push_back(fmt::format("{}={}", p.name, p.value));
  }
  all.emplace("parameters", fmt::format("{}", fmt::join(parameters, ",")));
  return all;
}

/// A word of the command with its replacement fields replaced; "{{" is a brace.
std::string filled(const Solver& solver, const std::string& word, const std::map<std::string, std::string>& values) {
  std::string text;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (word[k] != '{') {
      text += word[k];
      continue;
    }
    if (word.substr(k, 2) == "{{") {
      text += word[k++];
      continue;
    }
    const std::size_t close = word.find('}', k);
    const auto value = values.find(word.substr(k + 1, close - k - 1));
    if (close == word.npos || value == values.end()) {
      std::vector<std::string> known;
      for (const auto& [name, held] : values) known.push_back(name);
      throw std::invalid_argument(
          fmt::format("{}: command: '{}' is no replacement field, expected one of: {}; a brace is {{{{",
                      solver.file.string(), word.substr(k, close - k + 1), fmt::join(known, ", ")));
    }
    text += solver.is_for_shell ? programs::quoted(value->second) : value->second;
    k = close;
  }
  return text;
}

/// The command as a line of a shell.
std::string line_of(const Solver& solver, double spacing, const fs::path& folder) {
  const auto values = replacements(solver, spacing, folder);
  std::vector<std::string> words;
  for (const std::string& word : solver.command) {
    const std::string text = filled(solver, word, values);
    words.push_back(solver.is_for_shell ? text : programs::quoted(text));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

/// Files that fit the patterns, in the folder of a run; of what is not its output only what a pattern names in full.
std::vector<fs::path> files_of(const Solver& solver, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const std::string& pattern : solver.output) {
    glob_t found{};
    if (glob((folder / pattern).c_str(), 0, nullptr, &found) == 0)
      for (const fs::path file : std::span(found.gl_pathv, found.gl_pathc)) {
        const bool is_own = std::ranges::count(std::array{scene_file, particles_file, run_script, log_file},
                                               std::string_view(file.lexically_relative(folder).native())) > 0;
        if (!is_own || file == folder / pattern) files.push_back(file);
      }
    globfree(&found);
  }
  return files;
}

/// Keeps, of each time that was asked for, the nearest sample within 1 %; why there is no answer where one is missing.
std::string keep_asked(const std::vector<double>& times, std::map<double, Samples>& at) {
  std::map<double, Samples> kept;
  for (const double time : times) {
    const auto distance = [&](const auto& one) { return std::abs(one.first - time); };
    const auto nearest = std::ranges::min_element(at, {}, distance);
    if (nearest == at.end() || distance(*nearest) > time_tolerance * time) {
      std::vector<double> there;
      for (const auto& [t, samples] : at) there.push_back(t);
      return fmt::format("no output at {:g} s, expected it within 1 %; output is at {:g} s", time,
                         fmt::join(there, ", "));
    }
    kept.emplace(nearest->first, std::move(nearest->second));
    at.erase(nearest);
  }
  at = std::move(kept);
  return "";
}

constexpr std::string_view no_answer = "gave no result: ";

/// Reads what a run wrote into its level.
void read_level(const Solver& solver, double spacing, const fs::path& folder, Given& given) {
  Given own{.fields = given.fields};
  std::string why;
  try {
    const std::vector<fs::path> files = files_of(solver, folder);
    if (files.empty()) why = fmt::format("wrote no file {}", fmt::join(solver.output, ", "));
    for (const fs::path& file : files) read_into(own, solver.flow, solver.mapping, file, spacing);
    if (why.empty()) why = keep_asked(solver.times, own.levels.front().at);
  } catch (const std::exception& error) {
    why = error.what();
  }
  given.files.insert(given.files.end(), own.files.begin(), own.files.end());
  for (const std::string& line : own.words) given.say(line);
  GivenLevel level{.spacing = spacing};
  if (why.empty()) {
    level = std::move(own.levels.front());
    given.fields = own.fields;
  } else {
    level.outcome = fmt::format("{}{}", no_answer, why);
  }
  given.levels.push_back(std::move(level));
}

Judgement judged(const Solver& solver, Given given, Suite suite) {
  const std::optional<Baselines> baselines =
      solver.baselines.empty() ? std::nullopt : read_baselines(solver.baseline_file());
  Judgement judgement = judge_given(solver.flow, std::move(given),
                                    {.name = solver.name,
                                     .description = solver.description,
                                     .suite = suite,
                                     .at_most = solver.at_most,
                                     .order_at_least = solver.order_at_least,
                                     .baselines = baselines ? &*baselines : nullptr,
                                     .times = solver.times});
  const auto has_answer = [](const RunSummary& run) { return run.finished; };
  if (!std::ranges::all_of(judgement.record.runs, has_answer))  // said once, not of each order that is missing with it
    std::erase_if(judgement.record.verdicts,
                  [](const Verdict& v) { return std::isnan(v.value) && v.quantity != end_time_reached; });
  return judgement;
}

/// When run.sh began and ended [s since 1970]; empty while it runs and where it was killed. No pattern of output fits
/// it.
constexpr std::string_view began_and_ended = ".began_and_ended";

/// Of a run that somebody else made: its wall time, by run.sh.
programs::ProcessResult result_elsewhere(const fs::path& folder) {
  std::ifstream file(folder / began_and_ended);
  double began = 0, ended = 0;
  const bool is_known = file >> began >> ended && ended >= began;
  return {.cpu = not_a_number, .wall = is_known ? ended - began : not_a_number, .peak_memory = not_a_number};
}

/// In the resource that the solver says it occupies, else in user time.
Cost cost_of(const Solver& solver, const programs::ProcessResult& result) {
  Cost cost{.cpu = solver.resources > 0 ? not_a_number : result.cpu,
            .wall = result.wall,
            .peak_memory = result.peak_memory,
            .resource = solver.resource};
  cost.cpu_lowest = cost.cpu_highest = cost.cpu;
  if (solver.resources > 0) cost.occupied = result.wall * solver.resources;
  return cost;
}

}  // namespace

std::string missing_here(const Solver& solver) {
  const char* path = std::getenv("PATH");
  const auto is_here = [&](const std::string& what) {
    if (what.find('/') != what.npos) return fs::exists(what);
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
      if (access((fs::path(folder) / what).c_str(), X_OK) == 0) return true;
    return false;
  };
  std::vector<std::string> missing;
  for (const auto& [what, how] : solver.needs)
    if (!is_here(what)) missing.push_back(fmt::format("{} ({})", what, how));
  return fmt::format("{}", fmt::join(missing, ", "));
}

void prepare(const Solver& solver, const fs::path& folder) {
  for (const double spacing : solver.spacings) {
    const fs::path own = fs::absolute(folder) / name_of(solver, spacing);
    const std::string line = line_of(solver, spacing, own);  // before anything is removed
    fs::remove_all(own);
    fs::create_directories(own);
    files::write_whole(own / scene_file, scene_as_json(solver.flow, spacing));
    files::write_whole(own / particles_file, particles_as_csv(solver.flow, spacing));
    files::write_whole(own / run_script, fmt::format("#!/bin/sh\ncd {0}\n: > {1}\nbegan=$(date +%s.%N)\n"
                                                     "trap 'echo \"$began $(date +%s.%N)\" > {1}' EXIT\n{2}\n",
                                                     programs::quoted(own.string()), began_and_ended, line));
    fs::permissions(own / run_script, fs::perms::owner_exec, fs::perm_options::add);
  }
}

Judgement run_solver(const Solver& solver, const fs::path& folder, Suite suite,
                     const std::map<std::string, double>& expected) {
  prepare(solver, folder);
  Given given;
  programs::Work work;
  programs::Progress line(solver.case_and_method());
  for (const double spacing : solver.spacings) {
    const auto one = expected.find(level_name(solver.flow, spacing));
    work.expect(name_of(solver, spacing), one == expected.end() ? std::nullopt : std::optional(one->second));
  }
  for (const double spacing : solver.spacings) {
    work.begin(name_of(solver, spacing));
    const fs::path own = fs::absolute(folder) / name_of(solver, spacing), log = own / log_file;
    const programs::ProcessResult result = programs::run_limited(
        solver.case_and_method() + " " + name_of(solver, spacing), {"sh", (own / run_script).string()}, own, log,
        solver.limits, [&] { line.show([&] { return work.sentence(); }); });
    work.end(name_of(solver, spacing));
    if (result.succeeded()) {
      read_level(solver, spacing, own, given);
    } else {
      std::string said = programs::last_lines(log, 3);
      std::ranges::replace(said, '\n', ';');
      given.levels.push_back(
          {.spacing = spacing,
           .outcome = fmt::format("{}{}{}{}", no_answer, result.sentence(), said.empty() ? "" : "; it said: ", said)});
    }
    given.levels.back().cost = cost_of(solver, result);
  }
  return judged(solver, std::move(given), suite);
}

Judgement collect(const Solver& solver, const fs::path& folder, Suite suite) {
  Given given;
  for (const double spacing : solver.spacings) {
    const fs::path own = folder / name_of(solver, spacing);
    read_level(solver, spacing, own, given);
    given.levels.back().cost = cost_of(solver, result_elsewhere(own));
  }
  return judged(solver, std::move(given), suite);
}

void accept(const Solver& solver, const Record& record, const std::string& reason) {
  if (solver.baselines.empty())
    throw std::invalid_argument(
        fmt::format("{}: no key 'baselines', expected the folder for them", solver.file.string()));
  for (const Verdict& v : record.verdicts)
    if (v.outcome != Outcome::holds && v.quantity != anything_claimed)  // what is accepted is claimed from now on
      throw std::invalid_argument(fmt::format("nothing is accepted while a claim does not hold: {}", v.sentence));
  fs::create_directories(solver.baselines);
  Baselines all = read_baselines(solver.baseline_file()).value_or(Baselines{});
  std::erase_if(all.rows, [&](const Baseline& row) { return row.method == solver.name; });
  const std::vector<Baseline> rows =
      baselines_from(record, {.relative = solver.tolerance, .basis = "tolerance of the solver's file"});
  all.rows.insert(all.rows.end(), rows.begin(), rows.end());
  all.acceptance = {fmt::format("Last accepted values of {}", record.case_name), record.revision, record.finished_at,
                    reason};
  write_baselines(solver.baseline_file(), all.rows, all.acceptance);
}

}  // namespace touchstone::vnv::doors
