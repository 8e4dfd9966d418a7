#include "vnv/doors/read/parts/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>

namespace touchstone::vnv::doors {
namespace {

/// Properties of several numbers a particle are stored as one after the other; only real particles stay.
void make_rows(ParticleArray& particles, const std::string& where) {
  const auto named = [&](const char* name) { return std::ranges::find(particles.arrays, name, &Array::name); };
  const auto x = named("x");
  if (x == particles.arrays.end()) refuse(where, "no property 'x', expected one");
  const std::size_t rows = x->values.size();
  if (rows == 0) return particles.arrays.clear();
  std::erase_if(particles.arrays, [](const Array& array) { return array.values.empty(); });
  for (Array& array : particles.arrays) {
    if (array.values.size() % rows != 0)
      refuse(where, fmt::format("property '{}' of {} numbers, expected {} or a multiple", array.name,
                                array.values.size(), rows));
    array.components = static_cast<int>(array.values.size() / rows);
  }
  const auto tag = named("tag");
  if (tag == particles.arrays.end() || tag->components != 1) return;
  std::vector<bool> is_real(rows);
  std::transform(tag->values.begin(), tag->values.end(), is_real.begin(), [](double value) { return value == 0; });
  if (!std::all_of(is_real.begin(), is_real.end(), std::identity{}))
    for (Array& array : particles.arrays) keep_rows(array, is_real);
}

}  // namespace

bool names_time(std::string_view name) {
  const std::string_view plain = name.substr(0, name.find_first_of(" [("));
  constexpr std::array<std::string_view, 5> names = {"t", "time", "Time", "TIME", "TimeValue"};
  return std::ranges::find(names, plain) != names.end();
}

std::string unit_in(std::string_view name) {
  const std::size_t open = name.find_first_of("[(");
  const std::size_t close = open == name.npos ? open : name.find(name[open] == '[' ? ']' : ')', open);
  if (close == name.npos) return "";
  const std::string_view unit = name.substr(open + 1, close - open - 1);
  const bool is_index = std::ranges::all_of(unit, [](unsigned char c) { return c >= '0' && c <= '9'; });
  return is_index ? "" : std::string(unit);
}

void require_equal_rows(const std::vector<Array>& arrays, const std::string& source) {
  std::set<std::string> names;
  for (const Array& array : arrays) {
    if (!names.insert(array.name).second)
      refuse(source, fmt::format("array '{:.80}' twice, expected each name once", array.name));
    if (array.rows() != arrays.front().rows())
      refuse(source, fmt::format("array '{:.80}' of {} rows, expected {}, as '{:.80}' has", array.name, array.rows(),
                                 arrays.front().rows(), arrays.front().name));
  }
}

void keep_rows(Array& array, const std::vector<bool>& kept) {
  if (array.grid) {
    std::vector<std::size_t>& rows = array.grid->kept.emplace();
    rows.reserve(static_cast<std::size_t>(std::ranges::count(kept, true)));
    for (std::size_t row = 0; row < kept.size(); ++row)
      if (kept[row]) rows.push_back(row);
    return;
  }
  const auto width = static_cast<std::size_t>(array.components);
  std::size_t to = 0;
  for (std::size_t row = 0; row < kept.size(); ++row)
    if (kept[row]) {
      std::copy_n(array.values.begin() + static_cast<std::ptrdiff_t>(row * width), width,
                  array.values.begin() + static_cast<std::ptrdiff_t>(to));
      to += width;
    }
  array.values.resize(to);
}

std::vector<Dataset> parted_by_time(Dataset whole) {
  const auto time = std::ranges::find_if(
      whole.arrays, [](const Array& array) { return array.components == 1 && names_time(array.name); });
  std::vector<Dataset> all;
  if (whole.time || time == whole.arrays.end()) {
    all.push_back(std::move(whole));
    return all;
  }
  struct Part {
    std::size_t rows = 0, number = 0;
  };
  std::map<double, Part> parts;
  for (std::size_t k = 0; k < time->values.size(); ++k) {
    if (!std::isfinite(time->values[k]))
      refuse(whole.source, fmt::format("row {}: {:.80} = {}, expected a time", k + 1, time->name, time->values[k]));
    ++parts[time->values[k]].rows;
    if (parts.size() > Limits{}.most_datasets)
      refuse(whole.source,
             fmt::format("'{}' times or more, expected no more than {}", parts.size(), Limits{}.most_datasets));
  }
  if (parts.size() == 1) {
    whole.time = parts.begin()->first;
    whole.time_unit = unit_in(time->name);
    all.push_back(std::move(whole));
    return all;
  }
  all.reserve(parts.size());
  for (auto& [now, part] : parts) {
    part.number = all.size();
    all.push_back({.source = whole.source,
                   .format = whole.format,
                   .time = now,
                   .time_unit = unit_in(time->name),
                   .index = whole.index,
                   .rows_are = whole.rows_are,
                   .arrays = std::vector<Array>(whole.arrays.size())});
  }
  const auto place_of_time = static_cast<std::size_t>(time - whole.arrays.begin());
  const auto part_array = [&](std::size_t place) {
    Array& array = whole.arrays[place];
    const auto width = static_cast<std::size_t>(array.components);
    for (const auto& [now, part] : parts) {
      Array& to = all[part.number].arrays[place];
      to = {.name = array.name, .components = array.components, .values = {}, .labels = array.labels};
      reserve_more(to.values, part.rows * width);
    }
    auto part = parts.begin();
    consume_rows(array, [&](std::size_t first, std::span<const double> some) {
      for (std::size_t k = 0; k < some.size() / width; ++k) {
        const double now = time->values[first + k];
        if (part->first != now) part = parts.find(now);
        std::vector<double>& to = all[part->second.number].arrays[place].values;
        for (const double value : some.subspan(k * width, width)) to.push_back(value);
      }
    });
  };
  for (std::size_t place = 0; place < whole.arrays.size(); ++place)
    if (place != place_of_time) part_array(place);
  part_array(place_of_time);  // by which the others are parted
  return all;
}

std::vector<Array> rows_of(std::vector<Block> blocks, const std::string& source) {
  if (blocks.empty()) refuse(source, "no array of more than one number, expected some");
  const std::vector<std::size_t> shape = blocks[0].shape;
  const auto has = [&](const char* name) { return std::ranges::find(blocks, name, &Block::name) != blocks.end(); };
  const bool is_grid = shape.size() == 2 && has("x") && has("y") &&
                       std::ranges::all_of(blocks, [&](const Block& block) { return block.shape == shape; });
  std::vector<Array> arrays;
  for (Block& block : blocks) {
    const std::size_t width = block.shape.size() == 2 && !is_grid ? block.shape[1] : 1;
    const std::string where = fmt::format("{}: array '{:.80}'", source, block.name);
    if (block.values.empty()) refuse(where, "no number in it, expected rows");
    if (width > Limits{}.most_components)
      refuse(where, fmt::format("'{}' components, expected 1 to {}", width, Limits{}.most_components));
    arrays.push_back({.name = block.name, .components = static_cast<int>(width), .values = std::move(block.values)});
  }
  if (arrays.size() == 1 && arrays[0].components > 1) {
    Array table = std::move(arrays[0]);
    const auto width = static_cast<std::size_t>(table.components);
    arrays.assign(width, {});
    for (std::size_t k = 0; k < width; ++k) {
      arrays[k].name = fmt::format("column {}", k + 1);
      arrays[k].values.reserve(table.rows());
    }
    consume_rows(table, [&](std::size_t, std::span<const double> some) {
      for (std::size_t k = 0; k < width; ++k)
        for (std::size_t i = k; i < some.size(); i += width) arrays[k].values.push_back(some[i]);
    });
  }
  require_equal_rows(arrays, source);
  return arrays;
}

std::vector<Array> rows_of(std::vector<ParticleArray> all, const std::string& source) {
  Array of{.name = "array"};
  std::vector<Array> rows;
  for (ParticleArray& particles : all) {
    const std::string where = fmt::format("{}: particle array '{:.80}'", source, particles.name);
    make_rows(particles, where);
    const std::size_t before = of.values.size(), count = particles.arrays.empty() ? 0 : particles.arrays[0].rows();
    require_equal_rows(particles.arrays, where);
    of.values.resize(before + count, static_cast<double>(of.labels.size()));
    of.labels.push_back(particles.name);
    for (Array& array : particles.arrays) {
      const auto known = std::ranges::find(rows, array.name, &Array::name);
      const auto width = static_cast<std::size_t>(array.components);
      if (known == rows.end()) {
        array.values.insert(array.values.begin(), before * width, NAN);
        rows.push_back(std::move(array));
      } else if (known->components == array.components) {
        known->values.insert(known->values.end(), array.values.begin(), array.values.end());
        array.values = {};
      } else {
        refuse(where, fmt::format("property '{:.80}' of {} numbers a particle, expected {}", array.name,
                                  array.components, known->components));
      }
    }
    for (Array& array : rows) array.values.resize((before + count) * static_cast<std::size_t>(array.components), NAN);
  }
  if (of.values.empty()) refuse(source, "no real particle in it, expected particle arrays of PySPH");
  rows.push_back(std::move(of));
  require_equal_rows(rows, source);
  return rows;
}

}  // namespace touchstone::vnv::doors
