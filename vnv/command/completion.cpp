/// vnv completion: a script by which a shell completes subcommands, options and names of methods.

#include "vnv/command/commands.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::command {

std::string completion_script(const std::string& shell, const CommandWords& vnv,
                              const std::vector<CommandWords>& subcommands) {
  Words names;
  std::string cases;
  for (const CommandWords& command : subcommands) {
    names.push_back(command.name);
    const char* methods = command.takes_methods ? " $(\"${COMP_WORDS[0]}\" list --names 2>/dev/null)" : "";
    cases += fmt::format("    {}) words=\"{}{}\" ;;\n", command.name, fmt::join(command.options, " "), methods);
  }
  const char* for_zsh = "autoload -U +X compinit && compinit\nautoload -U +X bashcompinit && bashcompinit\n";
  return (shell == "zsh" ? for_zsh : "") +
         fmt::format(
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
             fmt::join(names, " "), cases, fmt::join(vnv.options, " "), fmt::join(suites, " "));
}

}  // namespace touchstone::vnv::command
