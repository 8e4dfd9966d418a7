#include "vnv/harness/options.hpp"

#include "vnv/files/data_folder.hpp"
#include "vnv/programs/command_line.hpp"

#include <algorithm>

namespace touchstone::vnv {

std::optional<int> Options::parse(const std::string& case_name, int count, char** arguments) {
  CLI::App app{
      fmt::format("{}: runs each method of the case, compares it with the oracle and judges it by its claims.\n"
                  "Example: {} --method mpm --suite acceptance --records build/records",
                  case_name, case_name)};
  app.name(case_name);
  std::vector<std::string> names;
  for (const Suite one : suites) names.emplace_back(name_of(one));
  app.add_option("--method", method, "only this method");
  app.add_option_function<std::string>(
         "--suite",
         [=, this](const std::string& name) { suite = suites[std::ranges::find(names, name) - names.begin()]; },
         "which levels run, and for how long: acceptance, report, nightly, work or validation")
      ->check(programs::one_of(names));
  app.add_option_function<std::string>(
      "--records", [this](const std::string& folder) { records = folder; }, "folder for the records, one per method");
  app.add_option_function<std::string>("--data", set_data_folder, "folder of experiments, papers and baselines");
  app.add_option_function<std::string>(
      "--vtp", [this](const std::string& folder) { vtp = folder; },
      "folder for the particles of each run at the times of the case, as a .vtp series for ParaView");
  app.add_option("--spacing", spacing, "make one run at this particle spacing [m], measured but not judged")
      ->check(programs::numbers());
  const CLI::Validator positive = programs::above_zero();
  app.add_option("--cell", cell,
                 "with --spacing: size of a background cell [m]; default: as on the level of nearest spacing")
      ->needs("--spacing")
      ->check(positive);
  app.add_option("--time-step", time_step, "with --spacing: time step [s]; default: that of the method")
      ->needs("--spacing")
      ->check(positive);
  app.add_option("--until", until, "with --spacing: end time [s]; default: the first time of the case")
      ->needs("--spacing")
      ->check(positive);
  app.add_option("--every", every,
                 "with --spacing: interval between measurements [s], from 0 on; default: at the times of the case")
      ->needs("--spacing")
      ->check(positive);
  app.add_option("--accept", accept_reason, "make today's values the baselines, for this reason");
  app.add_option_function<std::string>(
         "--mutate", [this](const std::string& folder) { mutated = folder; },
         "judge the records in this folder with each value beyond its limit, and list the claims that do not fail")
      ->check(programs::existing_folder());
  app.add_flag(
      "--mutate-samples", mutates_samples,
      "run, and alter the fields of the particles likewise; with --records, a record of each method that then fails");
  app.add_flag("--list", list, "name the methods and their levels");
  app.add_flag("--describe", describes, "print methods, levels, claims, tolerances and baselines as JSON");
  app.add_option("--ctest-file", ctest_file)->group("");
  if (const std::optional<int> status = programs::read_command_line(app, count, arguments)) return status;
  explores = app.count("--spacing") > 0;
  accepts = app.count("--accept") > 0;
  return std::nullopt;
}

}  // namespace touchstone::vnv
