#include "reports/figures/attachments.hpp"

#include "reports/figures/gnuplot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

/// The scripts of all cases, in the order of their names.
std::vector<fs::path> scripts_in(const fs::path& site) {
  std::vector<fs::path> scripts;
  for (const auto& entry : fs::recursive_directory_iterator(site))
    if (entry.path().extension() == ".gp") scripts.push_back(entry.path());
  std::ranges::sort(scripts);
  return scripts;
}

}  // namespace

std::string attach_figures(const fs::path& site, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::string lines;
  for (const fs::path& script : scripts_in(site)) {
    const std::string one = script.parent_path().filename().string(), figure = script.stem().string();
    const fs::path image = fs::absolute(folder / fmt::format("{}.{}.png", one, figure));
    run_gnuplot(script, image);
    lines += fmt::format("<CTestMeasurementFile name=\"{}, {}\" type=\"image/png\">{}</CTestMeasurementFile>\n", one,
                         figure, image.string());
  }
  return lines;
}

}  // namespace touchstone::reports
