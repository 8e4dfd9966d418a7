#include "vnv/judge/input_uncertainty.hpp"

#include "vnv/files/tables.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace touchstone::vnv {

double UncertainInput::standard() const { return is_deviation ? half_width : half_width / std::numbers::sqrt3; }

std::vector<UncertainInput> read_inputs(const std::filesystem::path& file) {
  const DataTable table = read_table(file);
  std::vector<UncertainInput> inputs;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const std::string &name = table.words("input")[k], &distribution = table.words("distribution")[k];
    const double half_width = table.numbers("half_width [SI]")[k];
    if (distribution != "rectangular" && distribution != "normal")
      throw BadData(
          file, 0,
          fmt::format("distribution of '{}'; found '{}', expected 'rectangular' or 'normal'", name, distribution));
    if (!(half_width > 0))
      throw BadData(file, 0, fmt::format("half width of '{}'; found {}, expected a positive number", name, half_width));
    inputs.push_back({name, table.numbers("value [SI]")[k], half_width, distribution == "normal",
                      table.words("unit")[k], table.words("basis")[k]});
  }
  return inputs;
}

const UncertainInput& input_named(std::string_view name, const std::vector<UncertainInput>& inputs) {
  const auto found = std::ranges::find(inputs, name, &UncertainInput::name);
  if (found != inputs.end()) return *found;
  std::vector<std::string> names;
  for (const UncertainInput& input : inputs) names.push_back(fmt::format("'{}'", input.name));
  throw std::invalid_argument(fmt::format("no input '{}'; found {}", name, fmt::join(names, ", ")));
}

Sensitivity sensitivity(const UncertainInput& input, const AtInput& low, const AtInput& high) {
  if (!(low.input < high.input))
    throw std::invalid_argument(fmt::format("sensitivity to {}: runs at {} and {}, expected the first to be lower",
                                            input.name, low.input, high.input));
  const double slope = (high.value - low.value) / (high.input - low.input);
  return {input.name, slope, std::abs(slope) * input.standard()};
}

double input_uncertainty(const std::vector<Sensitivity>& parts) {
  double squares = 0;
  for (const Sensitivity& one : parts) squares += one.part * one.part;
  return parts.empty() ? not_a_number : std::sqrt(squares);
}

}  // namespace touchstone::vnv
