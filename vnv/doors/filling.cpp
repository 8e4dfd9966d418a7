#include "vnv/doors/filling.hpp"

#include "solvers/lattice.hpp"
#include "vnv/measures/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace touchstone::vnv::doors {
namespace {

constexpr double room = 0.03;            // of mass and rows, for what another discretisation of a scene makes
constexpr double densest_lattice = 1.2;  // rows of one by a lattice of squares; hexagons: 2 / sqrt(3)
constexpr double least_rows = 4;         // fewer cannot show that they fill a plane
constexpr double other_depth = 3;        // masses by such a factor off are of a layer of another depth

/// What the scene holds at a resolution: rows, and the area [m²] that they stand for.
struct Expected {
  double rows, fewest, most, area;
  double on_walls = 0;  // rows of one line along each pair of walls

  Expected(const Flow& flow, double spacing) {
    const Vec2 size = flow.filled.size();
    rows = flow.filled_area() / (spacing * spacing);
    area = flow.filled_area();
    Vec2 counts = (size / spacing).array().round().max(1);
    if ((spacing <= size.array()).all() && counts.prod() < 1e8) {
      const Lattice regular = lattice(flow.filled, spacing);
      rows = static_cast<double>(flow.start.places_on(regular.places()).cols());
      area = rows * regular.volume();
    }
    for (const int axis : {0, 1})
      if (!flow.domain.periodic(axis)) on_walls += counts[1 - axis];
    double least = std::min(rows, flow.filled_area() / (spacing * spacing));
    if (flow.shape.empty()) least = std::min(least, (size / spacing).array().floor().max(1).prod());  // whole ones
    fewest = std::min((1 - room) * least, least - on_walls);
    most = std::max(densest_lattice * rows, rows + counts.sum() + 1);
  }
};

double median(Scalars values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The sum of V |v|² of the exact velocity at the rows, where it is known, else of that of the rows.
double squared_velocity(const Flow& flow, const Samples& s) {
  const Scalars volumes = s.volumes();
  if (const auto exact = std::ranges::find(flow.exact, "velocity", &Exact::field); exact != flow.exact.end()) try {
      const FieldTruth truth = exact->with({});
      double sum = 0;
      for (Index p = 0; p < s.size(); ++p) sum += volumes[p] * truth(s.x.col(p), s.time).squaredNorm();
      return sum;
    } catch (const std::exception&) {  // so long after its start
    }
  return (volumes * s.v.colwise().squaredNorm().transpose().array()).sum();
}

/// Takes the worst of each quantity: the farthest from `right`.
class Worst {
 public:
  void take(const Value& value, const std::string& where, double right = 0) {
    const auto known = std::ranges::find(found_.values, value.quantity, &Value::quantity);
    if (known == found_.values.end()) {
      found_.values.push_back(value);
      found_.where.emplace_back(value.quantity.name, where);
    } else if (!(std::abs(value.value - right) <= std::abs(known->value - right)) && !std::isnan(known->value)) {
      *known = value;
      std::ranges::find(found_.where, value.quantity.name, &std::pair<std::string, std::string>::first)->second = where;
    }
  }
  void claim(const Claim& claim) {
    const auto known = std::ranges::find(found_.claims, claim.quantity, &Claim::quantity);
    if (known == found_.claims.end())
      found_.claims.push_back(claim.on(found_.level));
    else if (claim.upper > known->upper)  // of a cloud, which stood on a grid at another time
      known->upper = claim.upper;
  }
  void tell(const std::string& line) {
    if (!has(found_.told, line)) found_.told.push_back(line);
  }

  Filling found_;
};

}  // namespace

bool is_of_filling(const std::string& quantity) {
  return is_of_coverage(quantity) || quantity == rows_found.name || quantity == mass_found.name ||
         quantity == mass_kept.name || quantity == density_found.name || quantity == without_velocity.name;
}

Filling filling_of(const Flow& flow, const std::string& level, const GivenLevel& given,
                   const std::vector<std::string>& fields) {
  Worst worst{{.level = level}};
  if (given.at.empty()) return worst.found_;
  const Expected expected(flow, given.spacing);
  const Samples& first = given.at.begin()->second;
  const double rows_at_first = static_cast<double>(first.size()), mass_at_first = first.mass.sum(),
               mass_of_scene = flow.fluid.density * expected.area, ratio = mass_at_first / mass_of_scene;
  const bool is_of_one_metre = ratio > 1 / other_depth && ratio < other_depth;
  const bool is_box = flow.shape.empty() && !flow.has_free_surface();
  const Author kept = theory("mass is conserved");
  const Slab in_a_plane;
  if (given.has_volumes && !is_of_one_metre)
    worst.tell(
        fmt::format("masses are {:.3g} times those of a layer 1 m deep: compared with those at the first time", ratio));
  for (const auto& [time, samples] : given.at) {
    const auto value = [&, at = time](const Quantity& quantity, double found) {
      return Value{level, given.spacing, at, quantity, found};
    };
    const double rows = static_cast<double>(samples.size());
    const auto found_slab = given.slabs.find(time);
    const Slab& slab = found_slab == given.slabs.end() ? in_a_plane : found_slab->second;
    if (slab.v.size() > 0)
      if (const double along = squared_velocity(flow, samples); along > 0) {
        const double across = (samples.volumes() * slab.v.square()).sum();
        worst.take(value(velocity_across, 100 * std::sqrt(across / along)), "");
        worst.claim(at_most(velocity_across, 20, theory("nothing drives a plane flow out of its plane")));
      }
    const Index components = has(fields, "velocity") ? 2 : has(fields, velocity_along_x) ? 1 : 0;
    if (const auto none = (!samples.v.topRows(components).array().isFinite()).colwise().any().count(); none > 0) {
      worst.take(value(without_velocity, static_cast<double>(none)), "");
      worst.claim(at_most(without_velocity, 0, theory("a velocity is a number")));
    }
    if (given.has_volumes) {
      const double mass = samples.mass.sum();
      const Quantity& quantity = is_of_one_metre ? mass_found : mass_kept;
      const double of_it = is_of_one_metre ? mass_of_scene : mass_at_first;
      worst.take(value(quantity, 100 * (mass / of_it - 1)), "");
      // Of a shape, what a coarse lattice cuts off its edge: up to half of the cells on it.
      const double of_edge = flow.area == 0 ? 0 : (expected.rows - expected.fewest) / expected.rows / 2,
                   of_walls = given.has_particles ? 1.01 * expected.on_walls / (expected.rows - expected.on_walls) : 0,
                   percent = 100 * std::max({room, of_edge, of_walls});
      worst.claim(between(quantity, -percent, percent, kept));
    }
    if (given.has_particles) {
      const bool is_counted = !given.has_volumes && (given.spacing_is_said || given.at.size() > 1);
      const double right = is_counted && given.spacing_is_said ? slab.layers * expected.rows : rows_at_first;
      worst.take(value(rows_found, rows),
                 fmt::format("{:.0f} {}", right,
                             right == rows_at_first ? "at the first time" : "in the scene at this resolution"),
                 right);
      if (!is_counted) {
        worst.claim(at_least(rows_found, least_rows, theory("fewer rows cannot show that they fill a plane")));
      } else {
        const double of_surface = is_box ? 0 : slab.layers * (expected.rows - expected.fewest);
        const double low = given.spacing_is_said ? slab.layers * expected.fewest : rows_at_first - of_surface,
                     high = given.spacing_is_said ? slab.layers * expected.most : rows_at_first + of_surface;
        worst.claim(between(rows_found, std::ceil(std::max(low, least_rows)), std::floor(high), kept));
      }
      const std::optional<Region> region = flow.region_at(time);
      for (int k = 0; k < slab.slices(); ++k) {
        Vectors of_slice;
        const Vectors& x = slab.in(k, samples.x, of_slice);
        if (x.cols() == 0) continue;  // rows of all slices are counted
        const Coverage coverage =
            coverage_of(x, given.spacing, region.value_or(Region{.domain = flow.domain, .is_known = false}));
        worst.found_.is_counted &= given.has_volumes || given.spacing_is_said || coverage.grid_places > 0;
        for (const Value& one : values_of(coverage, {.name = level, .spacing = given.spacing}, time))
          if (region || one.quantity != largest_hole) worst.take(one, where_is(coverage, one.quantity.name));
        for (const Claim& claim : fills_its_region(coverage, rows_at_first / slab.slices()))
          if (region || claim.quantity == rows_in_one_place || claim.quantity == rows_crowded) worst.claim(claim);
      }
    }
    if (has(fields, "density")) {
      const bool has_pressure = has(fields, "pressure") && samples.pressure.allFinite();
      const double law = has_pressure ? flow.fluid.density_at(median(samples.pressure)) : flow.fluid.density;
      worst.take(value(density_found, 100 * (median(samples.density) / law - 1)), "");
      worst.claim(between(density_found, -100 * room, 100 * room, theory("the density follows from the pressure")));
    }
  }
  return std::move(worst.found_);
}

}  // namespace touchstone::vnv::doors
