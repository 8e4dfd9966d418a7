/// vnv completion: a script by which a shell completes subcommands, options and names of methods.

#include "vnv/command/commands.hpp"
#include "vnv/command/joined.hpp"

#include <fmt/format.h>

#include <memory>

namespace touchstone::vnv::command {
namespace {

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

bool takes_patterns(const CLI::App& command) { return command.get_option_no_throw("PATTERN") != nullptr; }

/// What may follow a subcommand, as a line of the script.
std::string words_after(const CLI::App& command) {
  std::string words = joined(options_of(command), " ");
  if (command.get_name() == "completion") words += " bash zsh";
  if (takes_patterns(command)) words += " $(\"${COMP_WORDS[0]}\" list --names 2>/dev/null)";
  return fmt::format("    {}) words=\"{}\" ;;\n", command.get_name(), words);
}

std::string script_for_bash(const CLI::App& app) {
  std::vector<std::string> names;
  std::string after;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
    after += words_after(*command);
  }
  return fmt::format(
      "_vnv() {{\n"
      "  local word=\"${{COMP_WORDS[COMP_CWORD]}}\" before=\"${{COMP_WORDS[COMP_CWORD-1]}}\" words i command=\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    case \" {0} \" in *\" ${{COMP_WORDS[i]}} \"*) command=\"${{COMP_WORDS[i]}}\"; break ;; esac\n"
      "  done\n"
      "  case \"$command\" in\n"
      "{1}"
      "    *) words=\"{0} {2}\" ;;\n"
      "  esac\n"
      "  case \"$before\" in\n"
      "    --suite) words=\"{3}\" ;;\n"
      "    --build|--data|--records) COMPREPLY=($(compgen -d -- \"$word\")); return ;;\n"
      "  esac\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "}}\n"
      "complete -F _vnv vnv\n",
      joined(names, " "), after, joined(options_of(app), " "), joined(suites, " "));
}

int completion(const CLI::App& app, const std::string& shell) {
  if (shell == "zsh") fmt::print("autoload -U +X compinit && compinit\nautoload -U +X bashcompinit && bashcompinit\n");
  fmt::print("{}", script_for_bash(app));
  return all_holds;
}

}  // namespace

void add_completion(CLI::App& app, Session& session) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("completion", "Prints a script by which a shell completes commands, options and methods.");
  command->footer("Examples:\n  source <(vnv completion bash)\n  source <(vnv completion zsh)");
  command->add_option("SHELL", *shell, "bash or zsh")->required()->check(CLI::IsMember({"bash", "zsh"}));
  command->callback([&app, &session, shell] { session.todo = [&app, shell] { return completion(app, *shell); }; });
}

}  // namespace touchstone::vnv::command
