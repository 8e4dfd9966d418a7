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

std::string number_or_nothing(double value) { return std::isnan(value) ? "" : latex(value); }

std::string tex_of_verdicts(const CaseRecords& records, const std::vector<Reference>& references) {
  LatexTable table{{{"method", "l"},
                    {"level", "l"},
                    {"quantity", "p{4.5cm}"},
                    {"time [s]", "r"},
                    {"value", "r"},
                    {"limit", "r"},
                    {"limit set by", "p{4.5cm}"},
                    {"outcome", "l"}}};
  for_each(records, &vnv::Record::verdicts, [&](const vnv::Record&, const vnv::Verdict& v) {
    const std::string unit = v.unit.empty() ? "" : "\\," + latex(v.unit);
    std::vector<std::string> keys;
    for (const Reference& one : named_in(v.author, references)) keys.push_back(one.key);
    table.rows.push_back({latex(v.method), latex(v.level), latex(v.quantity), number_or_nothing(v.time),
                          latex(v.value) + unit, latex(printed_limit(v.lower, v.upper)) + unit,
                          latex(v.author) + (keys.empty() ? "" : fmt::format("~\\cite{{{}}}", fmt::join(keys, ","))),
                          latex(word(v.outcome))});
  });
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
std::string tex_of(const Versions& versions) {
  LatexTable table;
  for (const std::string& heading : versions.headings)
    table.columns.push_back({heading, heading == "methods" || heading == "flags" ? "p{4cm}" : "l"});
  for (const auto& row : versions.rows) {
    std::vector<std::string>& cells = table.rows.emplace_back();
    for (const std::string& cell : row) cells.push_back(latex(cell));
  }
  return to_latex(table);
}

std::string bib_of(const std::vector<Reference>& references) {
  std::string text;
  for (const Reference& one : references) text += (text.empty() ? "" : "\n") + one.entry;
  return text;
}

/// Scripts and data of all figures, then the PDF of each. The first that fails speaks for all.
void draw_figures(const CaseRecords& records, const fs::path& folder, Paper& paper) {
  std::vector<fs::path> scripts;
  for (const auto& plots : {plots_of_all(records), plots_of_orders(records)})
    for (const auto& [figure, plot] : plots) {
      for (const auto& [ending, text] : {std::pair(".gp", &plot.script), std::pair(".csv", &plot.data)}) {
        files::write_whole(folder / (figure.id + ending), *text);
        paper.files.push_back(folder / (figure.id + ending));
      }
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
  const CaseRecords judged = case_named(case_name, records);
  const std::vector<Reference> cited = references_of(judged, read_references(references));
  const Versions versions = versions_of(judged);
  fs::create_directories(folder);
  Paper paper;
  for (const auto& [name, text] :
       {std::pair("verdicts.tex", tex_of_verdicts(judged, cited)), std::pair("verdicts.csv", verdicts_csv({judged})),
        std::pair("values.csv", values_csv({judged})), std::pair("orders.csv", orders_csv({judged})),
        std::pair("cost.csv", cost_csv({judged})), std::pair("versions.tex", tex_of(versions)),
        std::pair("versions.csv", csv_of(versions)), std::pair("references.bib", bib_of(cited))}) {
    files::write_whole(folder / name, text);
    paper.files.push_back(folder / name);
  }
  draw_figures(judged, folder, paper);
  return paper;
}

}  // namespace touchstone::reports
