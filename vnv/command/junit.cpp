#include "vnv/command/junit.hpp"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <sstream>

namespace touchstone::vnv::command {

std::string junit_of(const Record& record) {
  pugi::xml_document document;
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  const std::string name = record.case_name + "." + record.method;
  const auto failures =
      std::ranges::count_if(record.verdicts, [](const Verdict& v) { return v.outcome != Outcome::holds; });
  suite.append_attribute("name") = name.c_str();
  suite.append_attribute("tests") = std::to_string(record.verdicts.size()).c_str();
  suite.append_attribute("failures") = std::to_string(failures).c_str();
  suite.append_attribute("timestamp") = record.finished_at.c_str();
  for (const Verdict& v : record.verdicts) {
    pugi::xml_node test = suite.append_child("testcase");
    test.append_attribute("classname") = name.c_str();
    test.append_attribute("name") =
        fmt::format("{}{}{}, {}", v.level, v.level.empty() ? "" : ": ", v.quantity, v.author).c_str();
    if (v.outcome != Outcome::holds) test.append_child("failure").append_attribute("message") = v.sentence.c_str();
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace touchstone::vnv::command
