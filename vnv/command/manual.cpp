/// vnv manual: the help texts as a page for man.

#include "vnv/command/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace touchstone::vnv::command {
namespace {

/// Text that roff sets as it is.
std::string plain(std::string_view text) {
  static const std::map<char, std::string_view> escapes{{'\\', "\\e"},  {'-', "\\-"},   {'\'', "\\(aq"},
                                                        {'~', "\\(ti"}, {'^', "\\(ha"}, {'`', "\\(ga"}};
  std::string all = text.starts_with('.') ? "\\&" : "";
  for (const char c : text) {
    const auto escape = escapes.find(c);
    if (escape == escapes.end())
      all += c;
    else
      all += escape->second;
  }
  return all;
}

/// A footer of a help text: indented lines as they are, all others filled, each sentence that opens a list or speaks
/// of the exit status a paragraph of its own.
std::string paragraphs(const std::string& footer) {
  std::string all;
  bool is_example = false;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    const bool is_indented = line.starts_with("  ");
    if (is_indented && !is_example) all += ".RS 4\n.nf\n";
    if (!is_indented && is_example) all += ".fi\n.RE\n";
    if (!is_indented && (all.empty() || is_example || line.starts_with("Example") || line.starts_with("Exit status")))
      all += ".PP\n";
    is_example = is_indented;
    all += plain(is_indented ? line.substr(2) : line) + "\n";
  }
  return all + (is_example ? ".fi\n.RE\n" : "");
}

std::string options_of(const CommandText& command) {
  std::string all;
  for (const OptionText& option : command.options) {
    if (std::ranges::find(option.names, "--help") != option.names.end()) continue;  // said once
    std::vector<std::string> names;
    for (const std::string& name : option.names)
      names.push_back(fmt::format("\\f{}{}\\fR", option.is_argument ? 'I' : 'B', plain(name)));
    all +=
        fmt::format(".TP\n{}{}{}\n{}{}\n", fmt::join(names, ", "),
                    option.is_argument || option.value.empty() ? "" : fmt::format(" \\fI{}\\fR", plain(option.value)),
                    option.may_repeat ? " ..." : "", plain(option.words),
                    option.initial.empty() ? "" : fmt::format("; default: {}", plain(option.initial)));
  }
  return all;
}

/// "vnv judge [options] FLOW FILES..."
std::string usage_of(const CommandText& command) {
  std::string all = fmt::format("\\fBvnv {}\\fR [options]", plain(command.name));
  for (const OptionText& option : command.options) {
    if (!option.is_argument) continue;
    const std::string name = fmt::format("\\fI{}\\fR{}", plain(option.value), option.may_repeat ? "..." : "");
    all += option.is_required ? " " + name : fmt::format(" [{}]", name);
  }
  return all;
}

std::string without_full_stop(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  if (!sentence.empty()) sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

}  // namespace

std::string manual_page(const CommandText& vnv, std::string_view version) {
  std::string page =
      fmt::format(".TH VNV 1 \"\" \"Touchstone {}\" \"User Commands\"\n.nh\n.SH NAME\nvnv \\- {}\n.SH SYNOPSIS\n",
                  version, plain(without_full_stop(vnv.what)));
  for (const CommandText& command : vnv.subcommands)
    page += (page.ends_with("SYNOPSIS\n") ? "" : ".br\n") + usage_of(command) + "\n";
  page += ".SH OPTIONS\nEach command also has these, and \\fB\\-\\-help\\fR, which prints what stands here of it.\n" +
          options_of(vnv) + ".SH COMMANDS\n";
  for (const CommandText& command : vnv.subcommands)
    page += fmt::format(".SS {}\n{}\n{}{}", usage_of(command), plain(command.what), paragraphs(command.footer),
                        options_of(command));
  return page + ".SH NOTES\n" + paragraphs(vnv.footer);
}

}  // namespace touchstone::vnv::command
