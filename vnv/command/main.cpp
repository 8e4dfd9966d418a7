/// vnv: one command for people; what it does is done by the programs that ctest calls. Here is its command line, and no
/// other file of it knows CLI11.

#include "vnv/command/commands.hpp"
#include "vnv/command/terminal.hpp"
#include "vnv/doors/fields.hpp"
#include "vnv/doors/read/format.hpp"
#include "vnv/files/data_folder.hpp"
#include "vnv/programs/command_line.hpp"
#include "vnv/programs/out_of_memory.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace touchstone::vnv::command {
namespace {

struct Session {
  CLI::App app{"Runs cases, judges them by their claims and explains them."};
  Build build{};
  std::function<int()> work{};  // what the command line asks for
};

/// Adds a subcommand that calls `work` with the options that `declare` declares.
template <class Work, class Options>
void add(Session& session, const std::string& name, const std::string& what, const std::string& footer, Work work,
         void (*declare)(CLI::App&, Options&)) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = session.app.add_subcommand(name, what);
  command->footer(footer);
  declare(*command, *options);
  command->callback([=, &session] { session.work = [=, &session] { return work(session.build, *options); }; });
}

/// An option whose value the help, the manual and completion know as that of a folder or a file.
template <class Value>
CLI::Option* add_folder(CLI::App& command, const std::string& name, Value& value, const std::string& what) {
  return command.add_option(name, value, what)->type_name("FOLDER");
}
template <class Value>
CLI::Option* add_file(CLI::App& command, const std::string& name, Value& value, const std::string& what) {
  return command.add_option(name, value, what)->type_name("FILE");
}

CLI::Option* add_suite(CLI::App& command, std::string& suite) {
  return command.add_option("--suite", suite, "acceptance, report, nightly, work or validation")
      ->type_name("SUITE")
      ->check(programs::one_of(suites))
      ->capture_default_str();
}

CLI::Option* add_patterns(CLI::App& command, Patterns& patterns) {
  return command.add_option("PATTERN", patterns,
                            "case, CASE.METHOD, glob or part of a name, or solver file (.toml); default: all");
}

void add_set(CLI::App& command, std::vector<std::string>& set) {
  command.add_option("--set", set, "parameter of the flow, in SI units; may be repeated")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
}

void add_results(CLI::App& command, ResultOptions& results) {
  add_folder(command, "--records", results.records,
             "for the record: JSON with every value and verdict, which vnv report turns into pages");
  add_file(command, "--junit", results.junit, "for the verdicts as JUnit XML, for continuous integration");
  command.add_flag("--json", results.as_json, "print JSON, for other programs");
}

void declare_list(CLI::App& command, ListOptions& options) {
  add_patterns(command, options.patterns);
  add_suite(command, options.suite);
  CLI::Option* json = command.add_flag("--json", options.as_json, "print JSON, for other programs");
  command.add_flag("--names", options.names_only, "print only CASE.METHOD, one per line")->excludes(json);
}

void declare_run(CLI::App& command, RunOptions& options) {
  add_patterns(command, options.patterns);
  add_suite(command, options.suite);
  EngineOptions& where = options.where;
  command
      .add_option(
          "-j", where.at_once,
          "programs to run at once; default: 1; with parallel, one per processor of each host; with slurm, all that "
          "it grants; those judged by run time run alone")
      ->check(programs::whole_numbers(1, 4096));
  add_folder(command, "--records", where.records, "of records; default: BUILD/records/SUITE");
  command
      .add_option(
          "--engine", where.engine,
          "local: on this machine; parallel: on hosts, by GNU parallel and ssh; slurm: on a cluster, by job arrays. "
          "All machines must see the build folder, the data and the records under the same paths")
      ->type_name("ENGINE")
      ->check(programs::one_of(engines))
      ->capture_default_str();
  command
      .add_option("--hosts", where.hosts,
                  "for parallel, in the form of its --sshlogin (4/user@host): separated by commas, or a file with one "
                  "per line; default: this machine")
      ->type_name("HOSTS");
  command
      .add_option("--engine-option", where.options,
                  "further option for parallel or sbatch, such as --partition=long; may be repeated")
      ->type_name("OPTION")
      ->allow_extra_args(false);
  command.add_flag("--again", options.again, "also run methods that would be skipped");
}

void declare_report(CLI::App& command, ReportOptions& options) {
  command.add_option("RECORDS", options.records, "folder of records; default: BUILD/records/SUITE");
  command.add_option("SITE", options.site, "folder for the pages, replaced if it exists; default: BUILD/site/SUITE");
  add_suite(command, options.suite);
  add_folder(command, "--history", options.history,
             "of earlier nights, to which these records are added; default: that of the build, if the records are its "
             "own");
  add_file(command, "--known-failures", options.known_failures,
           "of claims that are known to fail; default: known_failures.csv in the data folder");
  add_file(command, "--faults", options.faults,
           "with the results of the seeded faults; default: vnv/trials/faults/trials.csv in the sources");
}

void declare_export(CLI::App& command, ExportOptions& options) {
  command.add_option("CASE", options.case_name, "case, ours or that of another code, by the name of its page")
      ->required();
  add_folder(command, "--records", options.records, "of records; default: BUILD/records/SUITE");
  add_folder(command, "--folder", options.folder, "for the files; default: BUILD/export/CASE");
  add_suite(command, options.suite);
}

void declare_accept(CLI::App& command, AcceptOptions& options) {
  add_patterns(command, options.patterns)->required();
  command.add_option("--reason", options.reason, "why the new values are right; kept in the file")
      ->type_name("TEXT")
      ->required();
  add_suite(command, options.suite);
  add_folder(command, "--claims", options.claims,
             "run nothing and accept no values, only the number of claims that each method makes in this folder of "
             "records; accepted methods without a record there are removed")
      ->check(programs::existing_folder());
}

void declare_gate(CLI::App& command, GateOptions& options) {
  gate::GateRequest& request = options.request;
  command.add_option("BEFORE", request.before, "what to compare with")->required();
  command.add_option("AFTER", request.after, "what to judge")->required();
  add_suite(command, request.suite);
  command.add_option("--case", request.cases, "only this case; may be given several times")
      ->type_name("CASE")
      ->allow_extra_args(false);
  command.add_option("--only", request.only, "only methods whose CASE.METHOD contains this regular expression")
      ->type_name("EXPRESSION");
  command
      .add_option("--repeats", request.repeats, "alternating pairs of runs, 6 or more; 0: CPU times are not compared")
      ->check(programs::whole_numbers(0, 1000))
      ->capture_default_str();
  command.add_flag("--all", request.all, "also run programs that are the same in both");
  add_file(command, "--markdown", request.markdown, "for the findings as Markdown, to be pasted into a review");
  add_file(command, "--json", request.json, "for all findings as JSON, for other programs");
  add_folder(command, "--site", options.site, "for pages that show error against run time, before and after");
}

void declare_explain(CLI::App& command, ExplainOptions& options) {
  command.add_option("NAME", options.pattern, "case, CASE.METHOD, glob or part of a name, or flow")->required();
}

void declare_plan(CLI::App& command, PlanOptions& options) {
  add_patterns(command, options.patterns);
  add_suite(command, options.suite);
  command.add_option("-j", options.at_once, "programs to run at once; those judged by run time run alone")
      ->check(programs::whole_numbers(1, 4096))
      ->capture_default_str();
  command.add_flag("--json", options.as_json, "print one line of JSON per task; \"cpu\" is null where it is unknown");
}

void declare_scene(CLI::App& command, SceneOptions& options) {
  command.add_option("FLOW", options.flow,
                     "name of a flow, or a TOML file of formulas; without it, all flows are listed");
  add_set(command, options.set);
  command.add_option("--spacing", options.spacing, "particle spacing [m]; default: 40 particles across")
      ->check(programs::above_zero());
  command.add_flag("--json", options.as_json, "print JSON, for a solver");
  add_file(command, "--particles", options.particles, "for the initial particles, as CSV");
}

void declare_judge(CLI::App& command, JudgeOptions& options) {
  command.add_option("FLOW", options.flow, "name of a flow that vnv scene lists, or a TOML file of formulas")
      ->required();
  command.add_option("FILES", options.files, "output files, of one or more resolutions at one or more times")
      ->required();
  add_set(command, options.set);
  command.add_option("--name", options.name, "of the code that is judged")->type_name("CODE")->capture_default_str();
  command
      .add_option(
          "--field", options.fields,
          "array that holds a field, as in velocity=U; fields: position, velocity, pressure, density, mass, volume, "
          "and fraction of a volume that is fluid")
      ->type_name("FIELD=ARRAY")
      ->allow_extra_args(false);
  command
      .add_option(
          "--unit", options.units,
          "unit of length, velocity, pressure, density or time, as in length=mm; default: that of the headings or SI")
      ->type_name("KIND=UNIT")
      ->allow_extra_args(false);
  command
      .add_option(
          "--axes", options.axes,
          "axes of the plane of the flow, in the coordinates of the files; with - before one that runs the other way")
      ->type_name("AXES")
      ->check(programs::one_of(doors::names_of_planes()));
  command.add_option("--origin", options.origin, "origin of the flow, in the coordinates of the files [m]")
      ->expected(2)
      ->check(programs::numbers());
  command
      .add_option(
          "--only", options.only,
          "rows that are fluid, by the values of an array: NAME=VALUE, NAME>VALUE or NAME<VALUE; default: those "
          "that an array of names calls fluid or water, else all")
      ->type_name("ROWS");
  command.add_flag("--inside", options.inside, "leave out rows outside the domain");
  command.add_flag("--probes", options.probes,
                   "rows are places at which the flow was probed: whether all the fluid is there is not asked; so are "
                   "those of a table with one coordinate alone");
  command
      .add_option("--at", options.at, "coordinate [m] of the line along which a table has the other one, as in x=0.25")
      ->type_name("AXIS=PLACE");
  command
      .add_option("--symmetric", options.symmetric,
                  "line of symmetry of a half or quarter of the flow [m], as in y=0.5: the rows are mirrored about it")
      ->type_name("AXIS=PLACE")
      ->allow_extra_args(false);
  command.add_option("--time", options.time, "time of files without a time [s]")->check(programs::zero_or_above());
  command.add_option("--time-step", options.time_step, "time between consecutive indices of files without a time [s]")
      ->check(programs::above_zero());
  command
      .add_option("--spacing", options.spacing,
                  "particle spacing [m]; default: from the number of particles in the filled area")
      ->check(programs::above_zero());
  command
      .add_option(
          "--at-most", options.at_most,
          "limit for each error that is measured at the finest resolution, of every field and component, of periods, rates "
          "and fronts [%]")
      ->check(programs::above_zero());
  command.add_flag("--diagnose", options.results.diagnose,
                   "diagnose the errors of claims that hold, too, and list all causes that were fitted");
  add_results(command, options.results);
}

void declare_prepare(CLI::App& command, PrepareOptions& options) {
  command.add_option("SOLVER", options.solver, "solver file (.toml)")->required();
  command
      .add_option("FOLDER", options.folder, "output folder, one subfolder per resolution (existing ones are replaced)")
      ->required();
}

void declare_collect(CLI::App& command, CollectOptions& options) {
  command.add_option("SOLVER", options.solver, "solver file (.toml)")->required();
  command.add_option("FOLDER", options.folder, "folder made by vnv prepare")
      ->required()
      ->check(programs::existing_folder());
  add_suite(command, options.suite);
  add_results(command, options.results);
}

void declare_order(CLI::App& command, OrderOptions& options) {
  command.add_option("FILE", options.file, "table: a column that tells the resolution, and columns of errors")
      ->required();
  command.add_option("--resolution", options.table.resolution, "the column that tells the resolution, by its name");
  command
      .add_option("--told-by", options.table.told_by,
                  "what it holds: spacing, across (cells or particles along a side), all (that there are)")
      ->check(programs::one_of(ways_to_tell));
  command
      .add_option("--dimension", options.table.dimension,
                  "of the space that all cells or particles fill: 2 if not said")
      ->check(programs::whole_numbers(1, 3));
  command.add_flag(
      "--values", options.are_values,
      "the columns hold values whose exact value is unknown: extrapolate them, with the grid convergence index");
  command
      .add_option("--surely-above", options.surely_above,
                  "end with exit status 1 unless each 95 % interval lies above this order")
      ->check(programs::numbers());
  command
      .add_option("--formal-order", options.formal_order,
                  "of the method: an observed order far above it is not trusted; of --values 2 if not said")
      ->check(programs::above_zero());
}

OptionText text_of(const CLI::Option& option) {
  OptionText text{.value = option.get_type_name(),
                  .words = option.get_description(),
                  .initial = option.get_default_str(),
                  .is_argument = option.get_positional(),
                  .is_required = option.get_required(),
                  .may_repeat = option.get_items_expected_max() > 1 && option.get_type_size_max() == 1};
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (text.is_argument) text.names = {text.value = option.get_name(true)};
  return text;
}

CommandText text_of(const CLI::App& command) {
  CommandText text{command.get_name(), command.get_description(), command.get_footer()};
  for (const CLI::Option* option : command.get_options()) text.options.push_back(text_of(*option));
  for (const CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; }))
    text.subcommands.push_back(text_of(*one));
  return text;
}

void declare_completion(CLI::App& command, std::string& shell) {
  command.add_option("SHELL", shell, "bash or zsh")->required()->check(programs::one_of({"bash", "zsh"}));
}

struct NoOptions {};
void declare_nothing(CLI::App&, NoOptions&) {}

int print(const std::string& text) {
  fmt::print("{}", text);
  return all_holds;
}

void add_subcommands(Session& session) {
  add(session, "list", "Lists cases, methods and levels, and which suites run them.",
      "An installed copy, which has no cases, lists the flows by which any code can be judged.\n"
      "Examples:\n  vnv list\n  vnv list 'dam_*.mpm' --suite nightly\n  vnv list couette --json",
      list, declare_list);
  add(session, "run", "Runs methods and judges them by their claims.",
      "A method is skipped if the folder of records has a record of the same program, data and suite.\n"
      "On other machines it may take five times as long as last time, and is run again if its machine fails.\n"
      "What runs, what is left and how long that takes by the last records stands on stderr: on a terminal in one line,\n"
      "in a log from time to time.\n"
      "Examples:\n  vnv run couette.mpm\n  vnv run 'invariance_*' --suite nightly -j 2\n  vnv run --again --records mine\n"
      "  vnv run mine.toml\n  vnv run --suite nightly --engine parallel --hosts a,4/b\n"
      "  vnv run --suite nightly --engine slurm --engine-option=--partition=long",
      run, declare_run);
  add(session, "report", "Turns records into pages and prints the path of the first.",
      "Examples:\n  vnv report --suite nightly\n  vnv report my_records my_site --history my_nights", report,
      declare_report);
  add(session, "export", "Writes what a paper needs from a judged case: figures, tables, data, versions, citations.",
      "Figures as PDF, with their data and the gnuplot scripts that redraw them; claims and versions as tables for LaTeX\n"
      "(\\usepackage{array,booktabs,longtable}, \\input{verdicts}); all numbers as CSV; BibTeX of the literature that the\n"
      "case cites.\n"
      "Examples:\n  vnv export poiseuille\n  vnv export poiseuille --records mine --folder paper/poiseuille",
      export_case, declare_export);
  add(session, "accept",
      "Runs methods and makes their values the baselines, unless a claim from theory or literature fails.",
      "A suite that makes fewer claims than accepted fails: their number is accepted with the values.\n"
      "Examples:\n  vnv accept couette.mpm --reason \"the wall moves with the fluid now: second order\"\n"
      "  vnv accept couette.old --claims build/records/acceptance --reason \"one method fewer\"",
      accept, declare_accept);
  add(session, "gate", "Compares before and after: what got better, worse, slower or faster.",
      "BEFORE and AFTER are records, folders of records, build folders, two versions of a solver (.toml), or git\n"
      "revisions, which are built in temporary folders. Programs that differ are run alternately: their values are\n"
      "compared, and the ratio of their CPU times, or of their times on a resource that both occupy, is given with a\n"
      "95 % confidence interval.\n"
      "Exit status: 0 same or better, 1 worse, 2 inconclusive, 3 bad input, 4 bad usage.\n"
      "Examples:\n  vnv gate ../main/build build --markdown review.md\n"
      "  vnv gate HEAD~1 HEAD --case poiseuille --case couette\n  vnv gate old.toml new.toml\n"
      "  vnv gate nights/monday nights/tuesday --json gate.json",
      run_gate, declare_gate);
  add(session, "explain",
      "Explains what a case or a flow is, what is claimed and on whose authority, and where its data come from.",
      "A single method is explained with its claims and levels. A flow, by which any code is judged, is explained where\n"
      "no case of its name is built or installed.\n"
      "Examples:\n  vnv explain dam_break\n  vnv explain couette.mpm",
      explain, declare_explain);
  add(session, "plan", "Lists the methods and levels that a suite runs, with their last recorded cost.",
      "Examples:\n  vnv plan --suite nightly -j 8\n  vnv plan 'invariance_*' --json\n  vnv plan mine.toml", plan,
      declare_plan);
  add(session, "scene", "Prints all that a solver needs to compute a flow, at any parameters.",
      "Examples:\n  vnv scene\n  vnv scene poiseuille --set H=1 --set F=1e-5 --set nu=0.01\n"
      "  vnv scene taylor_green --spacing 0.02 --json --particles start.csv",
      scene, declare_scene);
  add(session, "judge", "Judges the output of any code for a flow: error norms, observed order, verdicts.",
      wrapped("Reads " + doors::formats_in_help() +
                  ", plain or gzipped. Files of equal spacing are taken as different times of one resolution; three "
                  "resolutions give the observed order.",
              110) +
          "Exit status: 0 all claims hold, 1 some do not or none was made, 3 bad input, 4 bad usage.\n"
          "Examples:\n  vnv judge poiseuille out.pvd --at-most 1\n"
          "  vnv judge couette run_40.csv run_80.csv run_160.csv --unit length=mm\n"
          "  vnv judge poiseuille --set H=1 --set L=0.4 --set nu=0.01 --set F=1e-5 --only array=fluid --at-most 1 "
          "pysph_100.npz\n"
          "  vnv judge taylor_green cells.vtu --set Re=100 --field velocity=U --axes xz --at-most 1\n"
          "  vnv judge stokes_second plate.h5 --at-most 1 --diagnose",
      judge, declare_judge);
  add(session, "prepare", "Makes a folder for each resolution of a solver, to be run elsewhere.",
      "Each holds scene.json, particles.csv and run.sh; when all have been run, vnv collect judges their output.\n"
      "Example:\n  vnv prepare mine.toml runs && for run in runs/*/run.sh; do sbatch \"$run\"; done",
      prepare, declare_prepare);
  add(session, "collect", "Judges the output of a prepared solver's runs.",
      "Example:\n  vnv collect mine.toml runs --records build/records/acceptance", collect, declare_collect);
  add(session, "order", "Shows the observed order of convergence of any table of errors, with its 95 % interval.",
      "The resolution is a column of spacings (h, dx, spacing), of cells along a side (N, nx, cells, H/dx) or of all there\n"
      "are (particles, np, dofs; with --dimension N and cells, too), known by its heading, else said with --resolution and\n"
      "--told-by; all others hold errors, but for orders, times, costs, parameters that do not change and words, which are\n"
      "left alone. Of signed errors the magnitudes count; a cell without a number ends with exit status 1. Rows in any\n"
      "order; cells separated by commas, semicolons, tabs, bars or blanks. For values whose exact value is unknown,\n"
      "--values gives, for each three consecutive resolutions, the order, Richardson's extrapolation and the grid\n"
      "convergence index of the finest (Roache 1998, Celik et al. 2008); where the order cannot be trusted, the numerical\n"
      "uncertainty at 95 % with a larger factor (Roache 1994, Eça & Hoekstra 2014).\n"
      "Examples:\n  vnv order errors.csv\n  vnv order errors.csv --surely-above 1.5\n  vnv order drag.csv --values",
      order, declare_order);
  add(
      session, "completion", "Prints a script that lets a shell complete commands, options, methods, flows and files.",
      "Examples:\n  source <(vnv completion bash)\n  source <(vnv completion zsh)",
      [&session](const Build&, const std::string& shell) {
        return print(completion_script(shell, text_of(session.app)));
      },
      declare_completion);
  add(
      session, "manual", "Prints these help texts as a page for man.", "Example:\n  vnv manual | man -l -",
      [&session](const Build&, NoOptions) { return print(manual_page(text_of(session.app), project_version())); },
      declare_nothing);
  for (CLI::App* command : session.app.get_subcommands([](CLI::App*) { return true; }))
    for (CLI::Option* option : command->get_options())
      if (option->get_positional()) option->type_name("");  // its name says what it is
}

/// Reads the command line; an exit status where nothing is left to do: help was asked for, or what is wrong was told.
std::optional<int> parse(Session& session, int count, char** arguments) {
  CLI::App& app = session.app;
  app.name("vnv");
  app.footer(
      "Examples:\n"
      "  vnv run poiseuille              judge each method of a case\n"
      "  vnv explain poiseuille.mpm      what is solved, claimed and cited\n"
      "  vnv run --suite nightly -j 4    a whole suite, four programs at once\n"
      "Each method is also a test: ctest -R '^poiseuille.mpm$', or '^nightly.poiseuille.mpm$'. Unit tests are run by "
      "ctest only: ctest -L unit.\n"
      "Exit status: 0 all claims hold, 1 some do not, 3 bad input, 4 bad usage.");
  app.require_subcommand(0, 1);  // that there is one is checked last, so that a misspelt one is named
  app.fallthrough();
  // This program lies in BUILD/vnv/, installed in PREFIX/lib/touchstone/vnv/.
  session.build.folder = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
  const std::string version = fmt::format("vnv (Touchstone) {}", project_version());
  app.set_version_flag("--version", version + (revision() == "unknown" ? "" : fmt::format(", revision {}", revision())),
                       "print version and revision, and exit");
  add_folder(app, "--build", session.build.folder, "where programs are; default: that of this program");
  add_folder(app, "--data", session.build.data, "of experiments, papers and baselines; default: that of the sources");
  add_subcommands(session);
  static_assert(bad_usage == programs::bad_usage);
  if (const std::optional<int> status = programs::read_command_line(app, count, arguments)) return status;
  if (session.work) return std::nullopt;
  fmt::print(stderr, "vnv: a subcommand is missing\n\n{}", app.help());
  return bad_usage;
}

int work(int count, char** arguments) {
  Session session;
  if (const std::optional<int> status = parse(session, count, arguments)) return *status;
  if (session.build.data.empty() && session.build.is_installed()) session.build.data = session.build.installed_data();
  if (!session.build.data.empty()) set_data_folder(session.build.data);
  return session.work();
}

}  // namespace
}  // namespace touchstone::vnv::command

int main(int count, char** arguments) {
  touchstone::programs::tell_when_out_of_memory("vnv", touchstone::vnv::command::bad_input);
  try {
    return touchstone::vnv::command::work(count, arguments);
  } catch (const touchstone::programs::Interrupted& interrupted) {
    fmt::print(stderr, "vnv: {}\n", interrupted.sentence());
    touchstone::programs::end_by(interrupted.signal);
  } catch (const std::exception& error) {
    fmt::print(stderr, "vnv: {}\n", error.what());
    return touchstone::vnv::command::bad_input;
  }
}
