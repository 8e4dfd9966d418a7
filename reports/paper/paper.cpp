#include "reports/paper/paper.hpp"

#include "reports/compare/work_precision.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/paper/latex.hpp"
#include "reports/paper/references.hpp"
#include "reports/read/csv.hpp"
#include "reports/text/notation.hpp"
#include "vnv/files/whole_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

CaseRecords case_named(const std::string& name, const fs::path& folder) {
  std::vector<std::string> known;
  for (CaseRecords& one : read_cases(folder)) {
    if (one.name == name) {
      add_work_precision(one);
      return std::move(one);
    }
    known.push_back(one.name);
  }
  throw std::runtime_error(
      fmt::format("{}: no case '{}', expected one of: {}", folder.string(), name, fmt::join(known, ", ")));
}

/// As `printed_limit`, with powers as in print; it may break before the unit.
std::string limit_of(const vnv::Verdict& v) {
  const std::string unit = v.unit.empty() ? "" : " " + latex(v.unit);
  if (v.lower && v.upper && *v.lower != *v.upper)
    return fmt::format("in [{}, {}]{}", latex(*v.lower), latex(*v.upper), unit);
  if (v.lower && v.upper) return "$=$ " + latex(*v.upper) + unit;
  if (v.lower) return "$\\ge$ " + latex(*v.lower) + unit;
  return v.upper ? "$\\le$ " + latex(*v.upper) + unit : latex(printed_limit(v.lower, v.upper));
}

std::string tex_of_verdicts(const CaseRecords& records, const std::vector<Reference>& references) {
  LatexTable table{{{"level and time", 0.155},
                    {"quantity", 0.17},
                    {"value", 0.185},
                    {"limit", 0.19},
                    {"set by", 0.165},
                    {"outcome", 0.135}}};
  for (const vnv::Record& record : records.records) {
    table.groups.push_back({latex(record.method)});
    for (const vnv::Verdict& v : record.verdicts) {
      const std::string unit = v.unit.empty() ? "" : " " + latex(v.unit);
      const std::string at = std::isnan(v.time) ? "" : latex(v.time) + "\\,s";
      std::vector<std::string> keys;
      for (const Reference& one : named_in(v.author, references)) keys.push_back(one.key);
      table.groups.back().rows.push_back(
          {latex(v.level) + (v.level.empty() || at.empty() ? "" : ", ") + at, latex(v.quantity), latex(v.value) + unit,
           limit_of(v), latex(v.author) + (keys.empty() ? "" : fmt::format("~\\cite{{{}}}", fmt::join(keys, ","))),
           latex(word(v.outcome))});
    }
  }
  return to_latex(table);
}

/// What a result was made of, once for all methods of one build.
struct Versions {
  std::vector<std::string> headings{"methods", "revision", "compiler", "flags", "machine", "suite", "finished"};
  std::vector<std::vector<std::string>> rows{};
};
Versions versions_of(const CaseRecords& records) {
  Versions all;
  for (const vnv::Record& record : records.records) {
    const std::vector<std::string> one{record.revision, record.compiler, record.flags,
                                       record.machine,  record.suite,    record.finished_at.substr(0, 10)};
    const auto same = std::ranges::find_if(
        all.rows, [&](const auto& row) { return std::equal(one.begin(), one.end(), row.begin() + 1); });
    if (same != all.rows.end()) {
      same->front() += ", " + record.method;
      continue;
    }
    all.rows.push_back({record.method});
    all.rows.back().insert(all.rows.back().end(), one.begin(), one.end());
  }
  return all;
}

std::string csv_of(const Versions& versions) {
  std::string text = csv_line(versions.headings);
  for (const auto& row : versions.rows) text += csv_line(row);
  return text;
}
/// One above the other: flags and methods are long.
std::string tex_of(const Versions& versions) {
  LatexTable table{{{"", 0.15}, {"", 0.85}}};
  for (const auto& row : versions.rows) {
    table.groups.emplace_back();
    for (std::size_t k = 0; k < row.size(); ++k)
      table.groups.back().rows.push_back({latex(versions.headings[k]), latex(row[k])});
  }
  return to_latex(table);
}

std::string bib_of(const std::vector<Reference>& references) {
  std::string text;
  for (const Reference& one : references) text += (text.empty() ? "" : "\n") + one.entry;
  return text;
}

/// Writes one more file. A name that is taken already is refused: one of two contents would be lost.
void put(Paper& paper, const fs::path& file, const std::string& text) {
  if (std::ranges::find(paper.files, file) != paper.files.end())
    throw std::runtime_error(fmt::format("{}: written twice, expected one content of each name", file.string()));
  files::write_whole(file, text);
  paper.files.push_back(file);
}

/// A figure that has the name of a table gets another beside it: cost.csv is the table, figure_cost.csv the figure.
void name_apart(CaseRecords& records, const std::set<std::string>& tables) {
  const auto rename = [&](std::string& figure) {
    if (tables.contains(figure)) figure = "figure_" + figure;
  };
  for (vnv::Record& record : records.records) {
    for (vnv::Figure& one : record.figures) rename(one.id);
    for (vnv::Curve& one : record.curves) rename(one.figure);
    for (vnv::Cloud& one : record.clouds) rename(one.figure);
  }
}

/// Scripts and data of all figures, then the PDF of each. The first that fails speaks for all.
void draw_figures(const CaseRecords& records, const fs::path& folder, Paper& paper) {
  std::vector<fs::path> scripts;
  for (const auto& plots : {plots_of_all(records), plots_of_orders(records)})
    for (const auto& [figure, plot] : plots) {
      put(paper, folder / (figure.id + ".gp"), plot.script);
      put(paper, folder / (figure.id + ".csv"), plot.data);
      scripts.push_back(folder / (figure.id + ".gp"));
    }
  for (const fs::path& script : scripts) {
    const fs::path image = fs::path(script).replace_extension(".pdf");
    try {
      run_gnuplot(script, image);
    } catch (const std::runtime_error& error) {
      paper.missing.push_back(fmt::format("figures are left as scripts and data: {}", error.what()));
      return;
    }
    paper.files.push_back(image);
  }
}

}  // namespace

Paper write_paper(const fs::path& records, const std::string& case_name, const fs::path& references,
                  const fs::path& folder) {
  CaseRecords judged = case_named(case_name, records);
  const std::vector<Reference> cited = references_of(judged, read_references(references));
  const Versions versions = versions_of(judged);
  fs::create_directories(folder);
  Paper paper;
  std::set<std::string> tables;
  for (const auto& [name, text] :
       {std::pair("verdicts.tex", tex_of_verdicts(judged, cited)), std::pair("verdicts.csv", verdicts_csv({judged})),
        std::pair("values.csv", values_csv({judged})), std::pair("orders.csv", orders_csv({judged})),
        std::pair("cost.csv", cost_csv({judged})), std::pair("versions.tex", tex_of(versions)),
        std::pair("versions.csv", csv_of(versions)), std::pair("references.bib", bib_of(cited))}) {
    put(paper, folder / name, text);
    tables.insert(fs::path(name).stem());
  }
  name_apart(judged, tables);
  draw_figures(judged, folder, paper);
  return paper;
}

}  // namespace touchstone::reports
