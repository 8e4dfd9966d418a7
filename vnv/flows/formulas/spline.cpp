#include "vnv/flows/formulas/spline.hpp"

#include "vnv/files/tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace touchstone::vnv::formulas {
namespace {

std::size_t column(const Sheet& sheet, const std::string& heading) {
  const auto& all = sheet.headings.cells;
  const auto found = std::ranges::find(all, heading);
  if (found == all.end())
    throw BadData(sheet.file, sheet.headings.line,
                  fmt::format("no column '{}', expected one of: {}", heading, fmt::join(all, ", ")));
  return static_cast<std::size_t>(found - all.begin());
}

}  // namespace

std::function<double(double)> spline_of(const std::filesystem::path& file, const std::string& of,
                                        const std::string& value) {
  const Sheet sheet = read_sheet(file);
  const std::size_t from = column(sheet, of), to = column(sheet, value);
  std::vector<double> x, y;
  for (const Sheet::Row& row : sheet.rows) {
    x.push_back(sheet.number(row, from));
    y.push_back(sheet.number(row, to));
    if (x.size() > 1 && !(x.back() > x[x.size() - 2]))
      throw BadData(file, row.line,
                    fmt::format("{} = {}, expected more than {} above it", of, x.back(), x[x.size() - 2]));
  }
  constexpr std::size_t least = 3;
  if (x.size() < least)
    throw BadData(file, 0, fmt::format("{} rows, expected {} or more for a spline", x.size(), least));
  const std::shared_ptr<gsl_spline> spline(gsl_spline_alloc(gsl_interp_cspline, x.size()), gsl_spline_free);
  gsl_spline_init(spline.get(), x.data(), y.data(), x.size());
  return [spline, low = x.front(), high = x.back()](double at) {
    return at >= low && at <= high ? gsl_spline_eval(spline.get(), at, nullptr) : NAN;
  };
}

}  // namespace touchstone::vnv::formulas
