#include "vnv/doors/given.hpp"

#include "solvers/lattice.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/scene.hpp"
#include "vnv/programs/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace touchstone::vnv::doors {
namespace {

/// Of a mesh its cells: what stands at its corners is interpolated from them.
std::vector<Dataset> rows_to_judge(std::vector<Dataset> all) {
  const auto is_of_cells = [](const Dataset& data) { return data.rows_are == Rows::cells; };
  if (std::ranges::any_of(all, is_of_cells)) std::erase_if(all, std::not_fn(is_of_cells));
  return all;
}

Vec2 middle_of(const Vectors& places) { return (places.rowwise().maxCoeff() + places.rowwise().minCoeff()) / 2; }
Vec2 spread_of(const Vectors& places) { return places.rowwise().maxCoeff() - places.rowwise().minCoeff(); }

/// Where the fluid is at a time, with half a spacing around rows that are so many.
Extent extent_of(const Flow& flow, double t, double rows) {
  Extent fluid{.area = flow.filled_area()};
  if (!flow.has_free_surface()) {
    fluid.about = flow.domain.box;
  } else if (const double spacing = std::sqrt(fluid.area / rows);
             t == 0 && (spacing <= flow.filled.size().array()).all()) {
    const Vectors start = places_at_start(flow, spacing);
    fluid.about = Box{.low = start.rowwise().minCoeff().array() - spacing / 2,
                      .high = start.rowwise().maxCoeff().array() + spacing / 2};
  } else if (const auto region = flow.region_at(t); region && !region->depth) {
    fluid.about = region->box;
  } else if (region) {  // what the box about it is, where it is all of the fluid: not below the troughs of a wave alone
    constexpr long many = 300;
    const Lattice all{region->box.low, region->box.size() / many, many, many};
    Box about{.low = Vec2::Constant(INFINITY), .high = Vec2::Constant(-INFINITY)};
    double area = 0;
    const Vectors places = all.places();
    for (const auto& x : places.colwise())
      if (region->depth(x) >= 0)
        about.low = about.low.cwiseMin(x), about.high = about.high.cwiseMax(x), area += all.volume();
    if (std::abs(area / fluid.area - 1) < 0.02) fluid.about = about;
  }
  return fluid;
}

/// Rows reach over most of the fluid, at the start over all of it; those in another unit or of a flow of another size
/// do not, nor does a single line. Where they lack a part of it along one axis, claims on its filling fail.
void require_filled(const Flow& flow, const std::string& source, const Samples& samples, double layers, double spacing,
                    const std::string& fits_with) {
  const Vec2 spread = spread_of(samples.x);
  const auto refuse = [&](const std::string& expected) {
    throw Unreadable(fmt::format("{}: rows spread over {:.4g} m by {:.4g} m, expected {}{}", source, spread.x(),
                                 spread.y(), expected, fits_with.empty() ? ": --set its size" : fits_with));
  };
  if (samples.size() < 4) return;
  const Extent fluid = extent_of(flow, samples.time, static_cast<double>(samples.size()) / layers);
  if (flow.has_free_surface() && samples.time == 0) {
    const Vectors start = places_at_start(flow, spacing);
    const Vec2 exact = spread_of(start), off = middle_of(samples.x) - middle_of(start);
    const Eigen::Array2d most_off = 2 * spacing + 0.05 * exact.array();
    if (((spread - exact).array().abs() > most_off).any())
      refuse(fmt::format("about {:.4g} m by {:.4g} m at the start", exact.x(), exact.y()));
    for (const int axis : {0, 1})
      if (!flow.domain.periodic(axis) && std::abs(off[axis]) > most_off[axis])
        throw Unreadable(fmt::format(
            "{}: the middle of the rows at the start is {:.4g} m off along {}, expected it where the fluid of the flow "
            "is{}",
            source, off[axis], "xy"[axis], fits_with.empty() ? ": --origin" : fits_with));
  } else if (!fluid.about) {
    if (spread.prod() < fluid.area / 2) refuse(fmt::format("room for the {:.4g} m² of fluid", fluid.area));
  } else if (const Vec2 size = fluid.about->size();
             !fits_with.empty() || !(spread.prod() > 0) || (spread.array() < size.array() / 2).all()) {
    refuse(fmt::format("most of the {:.4g} m by {:.4g} m of the fluid", size.x(), size.y()));
  }
}

/// By how much a velocity is off the exact one at places less a shift [m] and so many times their time, squared, by
/// about a thousand rows; not a number where it is not known.
double squared_off(const Flow& flow, const Samples& s, const Vec2& shift, double times) try {
  const auto exact = std::ranges::find(flow.exact, "velocity", &Exact::field);
  if (exact == flow.exact.end()) return not_a_number;
  const FieldTruth truth = exact->with({});
  double squared = 0;
  for (Eigen::Index p = 0; p < s.size(); p += 1 + s.size() / 1000)
    squared += (s.v.col(p) - truth(s.x.col(p) - shift, times * s.time)).head(exact->components).squaredNorm();
  return squared;
} catch (const std::exception&) {  // so long after its start
  return not_a_number;
}

/// Says in which unit the times of files may be written: the one in which their velocities are much nearer to the exact
/// ones, and than these at the start, which do not change.
void tell_unit_of_times(Given& given, const Flow& flow) {
  const auto off = [&](double seconds) {
    double squared = 0;
    for (const GivenLevel& level : given.levels)
      for (const auto& [time, samples] : level.at) squared += squared_off(flow, samples, Vec2::Zero(), seconds);
    return squared;
  };
  const double most = std::min(off(1), off(0)) / 16;
  for (const auto& [unit, seconds] : units_of_time)
    if (unit != "s" && off(seconds) < most)
      given.say(fmt::format("times in {0}? Velocities fit with --unit time={0}", unit));
}

/// Says of rows that span a periodic box and lie beside it which origin puts them into it, where their velocity is then
/// much nearer to the exact one: wrapped they may be right as they are.
void tell_where_periods_begin(Given& given, const Flow& flow, const std::string& source, const Reading& reading) {
  if (reading.beside.isZero(0)) return;
  if (squared_off(flow, reading.samples, reading.beside, 1) < squared_off(flow, reading.samples, Vec2::Zero(), 1) / 4)
    given.say(fmt::format("{}: the rows span the periodic box and lie beside it: they fit with{}", source,
                          reading.put_right));
}

/// Where nothing is judged of a velocity along x alone, both components of it are there or none.
void require_components(const Flow& flow, const std::string& source, const std::vector<std::string>& fields) {
  const auto needs_one = [](const Measured& one) { return has(one.fields, velocity_along_x); };
  if (has(fields, velocity_along_x) && !has(fields, "velocity") && std::ranges::none_of(flow.measured, needs_one))
    throw Unreadable(fmt::format("{}: velocity along x alone, expected its component along y too", source));
}

/// Volumes of a plane flow: equal ones of rows that have none, and about those of the fluid where its surface is free.
/// Those that fill a slab are divided by its depth.
void require_volumes(const Flow& flow, const std::string& source, double spacing, Reading& reading) {
  Samples& samples = reading.samples;
  const double area = flow.filled_area(), depth = reading.slab.layers * spacing;
  constexpr double most_off = 0.2;
  if (reading.has_volumes && !reading.slab.slice.empty() &&
      std::abs(samples.volumes().sum() / (area * depth) - 1) < most_off)
    samples.mass /= depth;
  if (!reading.has_volumes) {
    samples.mass = samples.density * (area / static_cast<double>(samples.size()));
  } else if (const double found = samples.volumes().sum();
             flow.has_free_surface() && std::abs(found / area - 1) > most_off) {
    throw Unreadable(fmt::format(
        "{}: volumes of {:.4g} m² in all, per metre of depth, expected {:.4g} m²: --set the size of the flow", source,
        found, area));
  }
}

double size_of(const std::filesystem::path& file) {
  std::error_code unknown;  // it is told when the file is read
  const auto bytes = std::filesystem::file_size(file, unknown);
  return unknown ? 0 : static_cast<double>(bytes);
}

/// How far [m] rows are from the nearest other one, by about a hundred of them: all but this part of them at least.
double apart(const Vectors& x, double part) {
  std::vector<double> nearest;
  for (Eigen::Index p = 0; p < x.cols(); p += 1 + x.cols() / 100) {
    double least = INFINITY;
    for (Eigen::Index q = 0; q < x.cols(); ++q)
      if (q != p) least = std::min(least, (x.col(q) - x.col(p)).squaredNorm());
    nearest.push_back(std::sqrt(least));
  }
  std::ranges::sort(nearest);
  return nearest[static_cast<std::size_t>(part * static_cast<double>(nearest.size()))];
}

/// Whether fewer rows are those of a coarser resolution, which stand farther apart almost everywhere, by as much as
/// their number says; where rows were lost many of the others stay as near to each other as they were. Of a cloud in
/// which distances scatter widely nobody can tell, and rows are lost.
bool is_coarser(const Vectors& x, const Vectors& before) {
  const double farther = std::sqrt(static_cast<double>(before.cols()) / static_cast<double>(x.cols())),
               nearest = apart(x, 0.1);
  return nearest > (1 + 0.6 * (farther - 1)) * apart(before, 0.1) && nearest > 0.9 * apart(before, 0.5);
}

/// Where the rows stand at the first time, of a slab those of one slice.
const Vectors& rows_at_first(const GivenLevel& level, Vectors& kept) {
  const auto& [time, samples] = *level.at.begin();
  const auto slab = level.slabs.find(time);
  return slab == level.slabs.end() ? samples.x : slab->second.in_the_fullest(samples.x, kept);
}

/// The level that a file's rows are of: one of its spacing, or one before of which rows are missing; each that has none
/// of its time yet. A code that loses rows has no coarser resolution.
GivenLevel& level_for(std::vector<GivenLevel>& levels, const GivenLevel& one) {
  const double time = one.at.begin()->first;
  const auto has_its_time = [&](const GivenLevel& level) {
    return std::ranges::any_of(level.at,
                               [&](const auto& at) { return std::abs(at.first - time) <= time_tolerance * time; });
  };
  const auto is_equal = [&](const GivenLevel& level) { return std::abs(level.spacing / one.spacing - 1) < 0.01; };
  const auto takes_it = [&](const GivenLevel& level) { return is_equal(level) && !has_its_time(level); };
  if (const auto equal = std::ranges::find_if(levels, takes_it); equal != levels.end()) return *equal;
  GivenLevel* before = nullptr;
  for (GivenLevel& level : levels) {
    if (one.spacing_is_said || has_its_time(level) || level.at.begin()->first > time) continue;
    Vectors of_level, of_one;
    const Vectors& first = rows_at_first(level, of_level);
    if (const Vectors& x = rows_at_first(one, of_one);
        x.cols() < first.cols() && (!before || level.spacing > before->spacing) && !is_coarser(x, first))
      before = &level;
  }
  if (before) return *before;
  if (const auto twice = std::ranges::find_if(levels, is_equal); twice != levels.end()) return *twice;
  return levels.emplace_back(GivenLevel{.spacing = one.spacing, .spacing_is_said = one.spacing_is_said});
}

/// How far [m] probes are from the nearest other one; one alone, all across.
double between_probes(const Flow& flow, const Vectors& x) {
  const double nearest = x.cols() > 1 ? apart(x, 0.5) : 0;
  return nearest > 0 ? nearest : flow.across;
}

/// Throws std::invalid_argument where the level has samples of that time.
void take(GivenLevel& level, Samples samples, double spacing, const std::string& where) {
  const double time = samples.time;
  if (!level.at.emplace(time, std::move(samples)).second)
    throw std::invalid_argument(
        fmt::format("{}duplicate spacing {:.4g} m and time {:g} s, expected each pair once", where, spacing, time));
}

}  // namespace

std::string level_name(const Flow& flow, double spacing) { return fmt::format("{:.4g} across", flow.across / spacing); }

void Given::say(const std::string& line) {
  if (!has(words, line)) words.push_back(line);
}

void Given::keep_fields(const std::vector<std::string>& those) {
  if (!fields) fields = those;
  std::erase_if(*fields, [&](const std::string& name) { return !has(those, name); });
}

void read_into(Given& given, const Flow& flow, const Mapping& by, Dataset data, std::optional<double> said) {
  Mapping mapping = by;
  const double middle = (flow.domain.box.low.x() + flow.domain.box.high.x()) / 2;
  mapping.probes |= data.rows_are == Rows::probes;
  mapping.probes |= complete_coordinates(data, by, {flow.is_uniform_along_x ? middle : not_a_number, not_a_number});
  Reading reading = reading_of(
      data, mapping, flow.domain, flow.fluid.density, [&](double t, double rows) { return extent_of(flow, t, rows); },
      said);
  data.arrays.clear();  // what stood in them is in the samples
  given.files.push_back(reading.file);
  for (const std::string& line : reading.words) given.say(line);
  given.keep_fields(reading.fields);
  if (given.levels.empty()) {
    const double rows = static_cast<double>(reading.samples.size()) / reading.slab.layers;  // of a layer
    const double counted =
        mapping.probes ? between_probes(flow, reading.samples.x) : std::sqrt(flow.filled_area() / rows);
    given.levels.push_back({.spacing = said.value_or(counted), .spacing_is_said = said.has_value()});
  }
  GivenLevel& level = given.levels.front();
  if (!mapping.probes)
    require_filled(flow, data.source, reading.samples, reading.slab.layers, level.spacing, reading.fits_with);
  tell_where_periods_begin(given, flow, data.source, reading);
  require_volumes(flow, data.source, level.spacing, reading);
  require_components(flow, data.source, reading.fields);
  given.say(fmt::format("spacing: {:.4g} m, {}", level.spacing,
                        said             ? "as said"
                        : mapping.probes ? "the distance between probes: --spacing is that of the code"
                        : reading.slab.slice.empty()
                            ? "the root of the filled area over the number of rows at the first time"
                            : "that at which so many rows fill the slab at the first time"));
  level.has_volumes &= reading.has_volumes;
  level.has_particles &= has(reading.fields, "particles");
  const double time = reading.samples.time;
  take(level, std::move(reading.samples), level.spacing, data.source + ": ");
  if (!reading.slab.slice.empty() || reading.slab.v.size() > 0) level.slabs.emplace(time, std::move(reading.slab));
}

void read_into(Given& given, const Flow& flow, const Mapping& mapping, const std::filesystem::path& file,
               std::optional<double> said) {
  for (Dataset& data : rows_to_judge(read_datasets(file))) read_into(given, flow, mapping, std::move(data), said);
}

Given together(std::vector<Given> each) {
  Given all;
  for (const Given& one : each) {
    all.files.insert(all.files.end(), one.files.begin(), one.files.end());
    for (const std::string& line : one.words) all.say(line);
    if (one.fields) all.keep_fields(*one.fields);
  }
  std::ranges::stable_sort(each, {}, [](const Given& one) { return one.levels.front().at.begin()->first; });
  for (Given& one : each) {
    GivenLevel& from = one.levels.front();
    GivenLevel& level = level_for(all.levels, from);
    level.has_volumes &= from.has_volumes;
    level.has_particles &= from.has_particles;
    for (auto& [time, samples] : from.at) take(level, std::move(samples), from.spacing, "");
    level.slabs.merge(from.slabs);
  }
  return all;
}

Given read_files(const Flow& flow, const std::vector<std::filesystem::path>& files, const Mapping& mapping,
                 std::optional<double> said) {
  programs::Work work(0);  // by the sizes of files
  programs::Progress line("vnv judge");
  for (const std::filesystem::path& file : files) work.expect(file, size_of(file));
  std::vector<Given> each;
  for (const std::filesystem::path& file : files) {
    work.begin(file);
    line.show([&] { return work.sentence(); });
    read_into(each.emplace_back(), flow, mapping, file, said);
    work.end(file);
  }
  line.clear();
  Given given = together(std::move(each));
  if (!mapping.time && !mapping.time_step && !mapping.units.contains("time")) tell_unit_of_times(given, flow);
  return given;
}

}  // namespace touchstone::vnv::doors
