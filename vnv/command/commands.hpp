#pragma once
/// The subcommands of `vnv`: a function each, with what its options say. Each returns an ExitStatus.

#include "vnv/command/catalogue.hpp"
#include "vnv/command/engines.hpp"
#include "vnv/command/order_table.hpp"
#include "vnv/gate/gate.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::vnv::command {

enum ExitStatus { all_holds = 0, something_fails = 1, bad_input = 3, bad_usage = 4 };

inline const std::vector<std::string> suites{"acceptance", "report", "nightly", "work", "validation"};

using Patterns = std::vector<std::string>;  // see patterns.hpp

struct ListOptions {
  Patterns patterns{};
  std::string suite{};  // empty: all
  bool as_json = false, names_only = false;
};
int list(const Build& build, ListOptions options);

struct RunOptions {
  Patterns patterns{};
  std::string suite = "acceptance";
  EngineOptions where{};  // without a folder of records: that of the build
  bool again = false;
};
int run(const Build& build, RunOptions options);

/// What is empty is found in the build folder.
struct ReportOptions {
  std::string records{}, site{}, suite = "acceptance", history{}, known_failures{}, faults{};
};
int report(const Build& build, const ReportOptions& options);

struct ExportOptions {
  std::string case_name{}, records{}, folder{}, suite = "acceptance";
};
int export_case(const Build& build, const ExportOptions& options);

struct AcceptOptions {
  Patterns patterns{};
  std::string reason{}, suite = "acceptance";
  std::filesystem::path claims{};  // records whose number of claims is accepted, and no value; empty: methods are run
};
int accept(const Build& build, AcceptOptions options);

struct GateOptions {
  gate::GateRequest request{};
  std::filesystem::path site{};  // empty: no pages
};
int run_gate(const Build& build, const GateOptions& options);

struct ExplainOptions {
  std::string pattern{};
};
int explain(const Build& build, const ExplainOptions& options);

struct PlanOptions {
  Patterns patterns{};
  std::string suite = "acceptance";
  int at_once = 1;
  bool as_json = false;
};
int plan(const Build& build, PlanOptions options);

/// What is empty is that of the published flow, or found in the files.
struct SceneOptions {
  std::string flow{};
  std::vector<std::string> set{};   // "H=1"
  std::optional<double> spacing{};  // m
  bool as_json = false;
  std::string particles{};  // a file to write
};
int scene(const Build& build, const SceneOptions& options);

/// What a judgement leaves: where nothing is named, words alone.
struct ResultOptions {
  std::string records{}, junit{};
  bool as_json = false, diagnose = false;
};

struct JudgeOptions {
  std::string flow{}, name = "files";
  std::vector<std::string> files{}, set{}, fields{}, units{};
  std::string axes{}, only{};
  std::vector<double> origin{};  // m
  bool inside = false, probes = false;
  std::string at{};                      // "x=0.25"
  std::vector<std::string> symmetric{};  // "y=0.5"
  ResultOptions results{};
  std::optional<double> time{}, time_step{}, spacing{}, at_most{};  // s, s, m, %
};
int judge(const Build& build, const JudgeOptions& options);

struct PrepareOptions {
  std::string solver{}, folder{};
};
int prepare(const Build& build, const PrepareOptions& options);

struct CollectOptions {
  std::string solver{}, folder{}, suite = "acceptance";
  ResultOptions results{};
};
int collect(const Build& build, const CollectOptions& options);

struct OrderOptions {
  std::string file{};
  SaidOfTable table{};
  bool are_values = false;  // of quantities whose truth nobody knows, not errors
  std::optional<double> surely_above{};
  std::optional<double> formal_order{};  // of the method
};
int order(const Build& build, const OrderOptions& options);

/// Of what this was built: "0.2.0"; and "5617f2c", with "-dirty" where that was changed, or "unknown".
std::string_view project_version();
std::string_view revision();

/// An option or an argument of a command, as its help has it.
struct OptionText {
  Words names{};          // "-h", "--help"; of an argument its own, "FLOW"
  std::string value{};    // what follows an option or is an argument, as in "FOLDER"; empty: nothing
  std::string words{};    // what it is
  std::string initial{};  // where it is not given; empty: what the words say
  bool is_argument = false, is_required = false, may_repeat = false;
};

/// A command, as its help has it.
struct CommandText {
  std::string name, what, footer;
  std::vector<OptionText> options{};
  std::vector<CommandText> subcommands{};
};

/// A script for bash or zsh by which the shell completes commands, options, and what follows them by the names of
/// their values.
std::string completion_script(const std::string& shell, const CommandText& vnv);

/// All help texts as a page for man, in roff.
std::string manual_page(const CommandText& vnv, std::string_view version);

/// Turns records into pages; `arguments` are those of touchstone_report. Throws std::runtime_error if it cannot;
/// something_fails where the pages are there and not green.
int make_pages(const Build& build, const Words& arguments);

}  // namespace touchstone::vnv::command
