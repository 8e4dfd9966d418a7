/// vnv completion: a script by which a shell completes subcommands, their options, and what follows these: methods,
/// flows, files. Which of them, the name of the value says, as the help prints it.

#include "vnv/command/commands.hpp"
#include "vnv/doors/fields.hpp"
#include "vnv/flows/formulas/flow_file.hpp"
#include "vnv/programs/programs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace touchstone::vnv::command {
namespace {

enum class Paths { none, folders, files, solvers };  // solvers: files that end in .toml, flows too
enum class Listed { none, cases, methods };          // by vnv list; methods: with their cases

/// What a value may be.
struct Values {
  Words words{};
  Paths paths = Paths::none;
  Listed listed = Listed::none;
};

const std::map<std::string, Values>& kinds_of_values() {
  static const std::map<std::string, Values> kinds{{"AFTER", {.paths = Paths::files}},
                                                   {"AXES", {.words = doors::names_of_planes()}},
                                                   {"BEFORE", {.paths = Paths::files}},
                                                   {"CASE", {.words = known_flows(), .listed = Listed::cases}},
                                                   {"ENGINE", {.words = engines}},
                                                   {"FILE", {.paths = Paths::files}},
                                                   {"FILES", {.paths = Paths::files}},
                                                   {"FLOW", {.words = known_flows(), .paths = Paths::solvers}},
                                                   {"FOLDER", {.paths = Paths::folders}},
                                                   {"NAME", {.words = known_flows(), .listed = Listed::methods}},
                                                   {"PATTERN", {.paths = Paths::solvers, .listed = Listed::methods}},
                                                   {"RECORDS", {.paths = Paths::folders}},
                                                   {"SHELL", {.words = {"bash", "zsh"}}},
                                                   {"SITE", {.paths = Paths::folders}},
                                                   {"SOLVER", {.paths = Paths::solvers}},
                                                   {"SUITE", {.words = suites}}};
  return kinds;
}

Words names_of_options(const CommandText& command) {
  Words names;
  for (const OptionText& option : command.options)
    if (!option.is_argument) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// "--suite=SUITE" of each option that a value follows.
Words values_of_options(const CommandText& command) {
  Words values;
  for (const OptionText& option : command.options)
    if (!option.is_argument && !option.value.empty())
      for (const std::string& name : option.names)
        values.push_back(
            fmt::format("{}={}", name, option.value.find('=') == option.value.npos ? option.value : "ANY"));
  return values;
}

Words arguments_of(const CommandText& command) {
  Words kinds;
  for (const OptionText& option : command.options)
    if (option.is_argument) kinds.push_back(option.value);
  return kinds;
}

std::string bash_script(const CommandText& vnv) {
  Words names, with_paths;
  std::string commands, kinds;
  for (const CommandText& command : vnv.subcommands) {
    names.push_back(command.name);
    commands += fmt::format("    {}) options='{}' values='{} {}' arguments='{}' ;;\n", command.name,
                            fmt::join(names_of_options(command), " "), fmt::join(values_of_options(vnv), " "),
                            fmt::join(values_of_options(command), " "), fmt::join(arguments_of(command), " "));
  }
  for (const auto& [name, values] : kinds_of_values()) {
    Words lines;
    if (!values.words.empty()) lines.push_back(fmt::format("compgen -W '{}' -- \"$2\"", fmt::join(values.words, " ")));
    if (values.listed != Listed::none)
      lines.push_back(fmt::format("compgen -W \"$(_vnv_{})\" -- \"$2\"",
                                  values.listed == Listed::cases ? "cases" : "cases; _vnv_methods"));
    if (values.paths == Paths::folders || values.paths == Paths::solvers) lines.push_back("compgen -d -- \"$2\"");
    if (values.paths == Paths::files) lines.push_back("compgen -f -- \"$2\"");
    if (values.paths == Paths::solvers) lines.push_back("compgen -f -X '!*.toml' -- \"$2\"");
    if (values.paths != Paths::none) with_paths.push_back(name);
    kinds += fmt::format("    {}) {} ;;\n", name, fmt::join(lines, "; "));
  }
  return fmt::format(R"bash(# Completion of vnv for bash.
_vnv_methods() {{ "${{COMP_WORDS[0]}}" list --names 2>/dev/null; }}
_vnv_cases() {{ _vnv_methods | cut -d . -f 1 | uniq; }}
_vnv_values() {{  # KIND BEGINNING
  case "$1" in
{kinds}  esac
}}
_vnv() {{
  local word="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" command= kind= i n=0 pair
  local options='{options}' values='{values}' arguments=
  for ((i = 1; i < COMP_CWORD; i++)); do
    case " {names} " in *" ${{COMP_WORDS[i]}} "*) command="${{COMP_WORDS[i]}}"; break ;; esac
  done
  case "$command" in
{commands}  esac
  if [[ "$before" == "=" ]]; then before="${{COMP_WORDS[COMP_CWORD-2]}}"; fi
  if [[ "$word" == "=" ]]; then word=; fi
  for pair in $values; do
    if [[ "$before" == "${{pair%%=*}}" ]]; then kind="${{pair#*=}}"; fi
  done
  if [[ -z "$kind" && ( -z "$arguments" || "$word" == -* ) ]]; then
    [[ -n "$command" ]] || options="{names} $options"
    COMPREPLY=($(compgen -W "$options" -- "$word"))
    return
  fi
  if [[ -z "$kind" ]]; then
    for ((i++; i < COMP_CWORD; i++)); do  # which argument it is
      case "${{COMP_WORDS[i]}}" in
        =) ((i++)) ;;
        -*) case " $values " in *" ${{COMP_WORDS[i]}}="*) ((i++)) ;; esac ;;
        *) ((n++)) ;;
      esac
    done
    for pair in $arguments; do
      kind="$pair"
      if ((n-- == 0)); then break; fi
    done
  fi
  case "$kind" in {with_paths}) compopt -o filenames 2>/dev/null ;; esac
  mapfile -t COMPREPLY < <(_vnv_values "$kind" "$word")
}}
complete -F _vnv vnv
)bash",
                     fmt::arg("kinds", kinds), fmt::arg("commands", commands), fmt::arg("names", fmt::join(names, " ")),
                     fmt::arg("options", fmt::join(names_of_options(vnv), " ")),
                     fmt::arg("values", fmt::join(values_of_options(vnv), " ")),
                     fmt::arg("with_paths", fmt::join(with_paths, "|")));
}

/// What follows the colon of an argument of zsh's _arguments.
std::string action_of(const std::string& kind) {
  const auto found = kinds_of_values().find(kind);
  if (found == kinds_of_values().end()) return " ";
  const Values& values = found->second;
  if (values.listed != Listed::none) return "_vnv_" + kind;
  switch (values.paths) {
    case Paths::folders:
      return "_files -/";
    case Paths::files:
      return "_files";
    case Paths::solvers:
      return "_files -g \"*.toml(-.)\"";
    case Paths::none:
      break;
  }
  return fmt::format("({})", fmt::join(values.words, " "));
}

/// Specifications for zsh's _arguments, each quoted, on lines of their own.
std::string specifications(const CommandText& command) {
  Words all;
  std::size_t arguments = 0;
  for (const OptionText& option : command.options) {
    if (option.is_argument) {
      const std::string place = option.may_repeat ? "*" : std::to_string(++arguments);
      all.push_back(fmt::format("{}:{}:{}", place, option.value, action_of(option.value)));
      continue;
    }
    std::string what;
    for (const char c : option.words.substr(0, option.words.find("; "))) {
      if (c == '[' || c == ']' || c == '\\') what += '\\';
      what += c;
    }
    for (const std::string& name : option.names)
      all.push_back(
          fmt::format("{}{}[{}]{}", option.may_repeat ? "*" : "", name, what,
                      option.value.empty() ? "" : fmt::format(":{}:{}", option.value, action_of(option.value))));
  }
  std::string lines;
  for (const std::string& one : all) lines += " \\\n        " + programs::quoted(one);
  return lines;
}

std::string zsh_script(const CommandText& vnv) {
  std::string commands, arguments;
  for (const CommandText& command : vnv.subcommands) {
    commands += fmt::format("    {}\n", programs::quoted(command.name + ":" + command.what));
    arguments += fmt::format("      {}) _arguments{} ;;\n", command.name, specifications(command));
  }
  return fmt::format(R"zsh(#compdef vnv
# Completion of vnv for zsh.
_vnv_methods() {{ methods=(${{(f)"$($_vnv_program list --names 2>/dev/null)"}}) }}
_vnv_CASE() {{
  local -aU methods cases
  _vnv_methods
  cases=(${{methods%%.*}} {flows})
  compadd -a cases
}}
_vnv_NAME() {{
  local -aU methods
  _vnv_methods
  methods+=(${{methods%%.*}} {flows})
  compadd -a methods
}}
_vnv_PATTERN() {{
  local -aU methods
  _vnv_methods
  methods+=(${{methods%%.*}})
  compadd -a methods
  _files -g "*.toml(-.)"
}}
_vnv() {{
  local curcontext="$curcontext" state line
  typeset -g _vnv_program="${{words[1]}}"
  local -a commands
  commands=(
{commands}  )
  _arguments -C{options} \
        '1: :->command' '*:: :->arguments' && return
  case "$state" in
    command) _describe -t commands command commands ;;
    arguments) case "${{words[1]}}" in
{arguments}    esac ;;
  esac
}}
if [[ "${{funcstack[1]}}" == _vnv ]]; then
  _vnv "$@"
else
  (( $+functions[compdef] )) || {{ autoload -U compinit && compinit; }}
  compdef _vnv vnv
fi
)zsh",
                     fmt::arg("commands", commands), fmt::arg("arguments", arguments),
                     fmt::arg("options", specifications(vnv)), fmt::arg("flows", fmt::join(known_flows(), " ")));
}

}  // namespace

std::string completion_script(const std::string& shell, const CommandText& vnv) {
  return shell == "zsh" ? zsh_script(vnv) : bash_script(vnv);
}

}  // namespace touchstone::vnv::command
