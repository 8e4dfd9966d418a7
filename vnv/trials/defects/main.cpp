/// touchstone_defects [--only TEXT] [--night] [--seed N]: would the judge see it? Defects are planted into right data
/// of every flow and judged as files are; what must be said of each is written down here, once.

#include "vnv/doors/filling.hpp"
#include "vnv/doors/judge.hpp"
#include "vnv/doors/right_data.hpp"
#include "vnv/programs/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <type_traits>

namespace {

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::doors;
using Index = Eigen::Index;
using Generator = std::mt19937;

/// What rows are, and what is known of them. But for those that are said, resolutions are counted from the rows.
enum class Kind { cells, lattice, cloud, said, weighed };  // cells have volumes, rows that are weighed mass and density
const std::vector<std::pair<Kind, const char*>> kinds{{Kind::cells, "cells"},
                                                      {Kind::lattice, "lattice"},
                                                      {Kind::cloud, "cloud"},
                                                      {Kind::said, "cloud, --spacing"},
                                                      {Kind::weighed, "cloud, weighed"}};

struct Data {
  Kind kind = Kind::cells;
  bool is_said = false;
  std::vector<double> across{};                // of each level
  std::vector<std::vector<Samples>> levels{};  // at each time
};

/// What stands in a column of the table: how it is judged.
struct Asked {
  std::vector<double> across, times;
};
Asked asked_of(const Flow& flow) {
  const auto every = [](double step, double end) {
    std::vector<double> times;
    for (int k = 0; k * step <= end * (1 + 1e-9); ++k) times.push_back(k * step);
    return times;
  };
  if (flow.name == "standing_wave") return {{32, 48, 72}, every(0.125, 4)};
  if (flow.name == "elliptic_drop") return {{16, 24, 36}, {0, 0.4, 0.8}};
  if (flow.name == "rotating_patch") return {{20, 40, 80}, {0, 0.5, 1}};
  if (flow.name == "hydrostatic") return {{10, 20, 40}, {0, 0.5, 1, 2}};
  if (flow.name == "cavity") return {{24, 48, 72}, {7, 12}};
  if (flow.name == "dam_break") {
    std::vector<double> times = flow.judged.times;
    times.insert(times.begin(), 0);
    return {{15, 30, 45}, times};
  }
  return {{10, 20, 40}, flow.judged.times};
}

/// Which data of a flow, as right_of takes them.
struct Request {
  double across, t, shaken;
  unsigned seed;
};
Samples right(const Flow& flow, const Request& r) { return right_of(flow, r.across, r.t, r.shaken, r.seed); }
using Answer = std::function<Samples(Request)>;

Data data_of(const Flow& flow, Kind kind, std::size_t levels, unsigned seed, const Answer& answer) {
  const Asked asked = asked_of(flow);
  Data data{.kind = kind, .is_said = kind == Kind::said};
  data.across = levels == 1 ? std::vector{asked.across[1]} : asked.across;
  for (const double n : data.across) {
    std::vector<Samples>& at = data.levels.emplace_back();
    for (const double t : asked.times) {
      at.push_back(answer({n, t, kind == Kind::cells || kind == Kind::lattice ? 0 : 0.25, seed}));
      at.back().time = t;
    }
  }
  return data;
}

Dataset dataset_of(const Data& data, const Samples& s) {
  Dataset set{.source = "planted", .format = "none", .time = s.time};
  const auto add = [&](const std::string& name, int components, const auto& value) {
    Array& array = set.arrays.emplace_back(Array{name, components});
    for (Index p = 0; p < s.size(); ++p)
      for (int k = 0; k < components; ++k) array.values.push_back(value(p, k));
  };
  add("position", 2, [&](Index p, int k) { return s.x(k, p); });
  add("velocity", 2, [&](Index p, int k) { return s.v(k, p); });
  add("pressure", 1, [&](Index p, int) { return s.pressure[p]; });
  if (data.kind == Kind::weighed) {
    add("density", 1, [&](Index p, int) { return s.density[p]; });
    add("mass", 1, [&](Index p, int) { return s.mass[p]; });
  } else if (data.kind == Kind::cells) {
    set.rows_are = Rows::cells;
    set.cell_dimensions = 2;
    add(cell_volumes_array, 1, [&](Index p, int) { return s.mass[p] / s.density[p]; });
  }
  return set;
}

/// What was said of data: verdicts that do not hold, or why nothing was judged; and what was told.
struct Said {
  std::set<std::string> red{};  // quantities
  std::string complaints{}, told{};
};

Said said_of(const Flow& flow, const Data& data, bool is_limited_to_one_percent) {
  Said said;
  try {
    std::vector<Given> each;
    for (std::size_t k = 0; k < data.levels.size(); ++k)
      for (const Samples& s : data.levels[k])
        read_into(each.emplace_back(), flow, {}, dataset_of(data, s),
                  data.is_said ? std::optional(flow.across / data.across[k]) : std::nullopt);
    const Judgement judgement = judge_given(flow, together(std::move(each)),
                                            {.at_most = is_limited_to_one_percent ? std::optional(1.0) : std::nullopt});
    for (const Verdict& v : judgement.record.verdicts)
      if (v.outcome != Outcome::holds) {
        said.red.insert(v.quantity);
        said.complaints += v.sentence + "\n";
      }
    for (const std::string& line : judgement.words) said.told += line + "\n";
    for (const std::string& line : judgement.not_judged) said.told += line + "\n";
    for (const Value& value : judgement.record.values)
      if (!is_limited(value, judgement.record)) said.told += "not limited: " + value.quantity.name + "\n";
  } catch (const std::exception& refusal) {
    said.red = {"refused"};
    said.complaints = std::string("refused: ") + refusal.what();
  }
  return said;
}

// How far planted data are from what is exact at their places, by its own sums: the judge's are what is tried.

const Exact* exact_of(const Flow& flow, const std::string& field) {
  const auto found = std::ranges::find(flow.exact, field, &Exact::field);
  return found == flow.exact.end() ? nullptr : &*found;
}

struct Off {
  double mean = 0, largest = 0, part = 1;  // of the exact field
};
Off off_of(const Flow& flow, const std::string& field, const Data& data) {
  const FieldTruth truth = exact_of(flow, field)->with({});
  Off worst;
  for (const std::vector<Samples>& level : data.levels)
    for (const Samples& s : level) {
      const double n = static_cast<double>(s.size());
      Vectors exact(2, s.size()), found = Vectors::Zero(2, s.size());
      for (Index p = 0; p < s.size(); ++p) exact.col(p) = truth(s.x.col(p), s.time);
      if (field == "velocity")
        found = s.v;
      else
        found.row(0) = s.pressure;
      if (exact_of(flow, field)->less_mean)
        for (Vectors* all : {&exact, &found}) all->colwise() -= (all->rowwise().sum() / n).eval();
      if (!(exact.norm() > 0)) continue;
      const double mean = (found - exact).norm() / exact.norm(),
                   largest = (found - exact).colwise().norm().maxCoeff() / exact.colwise().norm().maxCoeff(),
                   part = found.cwiseProduct(exact).sum() / exact.squaredNorm();
      worst.mean = std::max(worst.mean, mean), worst.largest = std::max(worst.largest, largest);
      if (std::abs(part - 1) > std::abs(worst.part - 1)) worst.part = part;
    }
  return worst;
}

// What must be said: "red: A or B" of a verdict that fails, or a refusal, with any of these words; "...; says: C or D"
// of its sentences, too; "told: A or B"; "green: why"; "open: why" where it is between what is visible and what is not.

/// A defect in data of a flow, planted and as it was.
struct Planted {
  const Flow& flow;
  const Data& right;
  const Data& planted;
  bool is_limited;

  bool has_particles() const { return right.kind != Kind::cells; }
  bool has_volumes() const { return right.kind == Kind::cells || right.kind == Kind::weighed; }
  /// Whether rows of a lattice are seen as an upright grid.
  bool is_on_grid(bool at_last_only) const {
    return right.kind == Kind::lattice && flow.area == 0 && flow.name != "standing_wave" &&
           (!at_last_only || flow.region_at(1));
  }
  /// The part of its rows that a level may lack, by walls without rows; of the level that may lack least.
  double room() const {
    double least = 1;
    for (std::size_t k = 0; k < right.levels.size(); ++k) {
      double lines = 0;
      for (const int axis : {0, 1})
        if (!flow.domain.periodic(axis)) lines += flow.filled.size()[1 - axis] / flow.across * right.across[k];
      least = std::min(least, lines / static_cast<double>(right.levels[k][0].size()));
    }
    return std::max(0.03, least);
  }
};
using Must = std::function<std::string(const Planted&)>;

/// Rows that are missing at all times, or at the last alone.
std::string where_missing(const Planted& c, double part, double hole, bool at_last_only = false) {
  const bool is_hole = c.has_particles() && hole >= 4 && !(at_last_only && !c.flow.region_at(1));
  if (is_hole) return "red: largest hole or empty places or refused";
  const double room_of_mass = c.flow.area == 0 ? 0.03 : std::max(0.03, c.room() / 2);
  if (c.has_volumes() && part > 1.1 * room_of_mass) return "red: mass or refused";
  if (c.right.kind == Kind::said && part > 1.1 * c.room()) return "red: rows or largest hole or order or refused";
  if (c.is_on_grid(at_last_only) && part > 0 && part < 0.15) return "red: empty places";
  if (at_last_only && !c.has_volumes() && part > (c.flow.has_free_surface() ? 1.1 * c.room() : 0)) return "red: rows";
  if (c.flow.name == "rotating_patch") return "open: its momentum is no longer that of all of it";
  if (part * static_cast<double>(c.right.levels.back()[0].size()) < 1.5) return "green: one row";
  if (!c.has_volumes() && c.right.kind != Kind::said && !at_last_only) return "told: how many rows there should be";
  return "open: about what nodes and walls explain";
}

/// What the velocity is off by must be seen as it is large. `otherwise` of flows without an exact one.
std::string by_velocity(const Planted& c, const std::string& otherwise, const std::string& says = "") {
  if (!exact_of(c.flow, "velocity")) return otherwise;
  const Off off = off_of(c.flow, "velocity", c.planted), before = off_of(c.flow, "velocity", c.right);
  const double visible = c.is_limited ? off.largest : off.mean;
  if (visible < 1.01 * (c.is_limited ? before.largest : before.mean)) return "green: the field is the same";
  const double least = c.is_limited || c.flow.name != "elliptic_drop" ? 0.013 : 0.21;
  if (visible < least) return "open: less than is visible";
  return "red: L2 or Linf or order" + (says.empty() || !c.is_limited || off.mean < 0.05 ? "" : "; says: " + says);
}
std::string by_pressure(const Planted& c, const std::string& otherwise, const std::string& says = "") {
  const Exact* exact = exact_of(c.flow, "pressure");
  if (!exact) return otherwise;
  const Off off = off_of(c.flow, "pressure", c.planted), before = off_of(c.flow, "pressure", c.right);
  if (off.mean < 1.01 * before.mean) return "green: the field is the same";
  if (off.part < 0.49 || off.part > 1.51) return "red: part of the exact or L2 p";
  if (off.mean < 0.013) return "open: less than is visible";
  if (!c.is_limited && exact->less_mean) return "told: not limited: L2 p";
  return "red: L2 p or order" + (says.empty() || !c.is_limited || off.mean < 0.05 ? "" : "; says: " + says);
}

/// What is said of a velocity or a pressure times so much where no exact field is known.
std::string by_factor_of_velocity(const Planted& c, double factor) {
  const double off = std::abs(factor - 1);
  const std::string& name = c.flow.name;
  if (name == "hydrostatic") return "green: there is none";
  if (name == "standing_wave" || name == "dam_break")
    return factor < 0.4 || factor > 1.6 ? "red: part of the motion or kinetic"
                                        : "open: a rate over few times is known to a factor";
  if (name == "cavity") return off > 0.3 ? "red: L2 v" : "open: about what is claimed";
  return off > 0.055 ? "red: angular momentum or kinetic energy" : "open: about what methods lose";  // rotating_patch
}
std::string by_factor_of_pressure(const Planted& c, double factor) {
  const std::string& name = c.flow.name;
  if (name == "elliptic_drop") {
    if (std::abs(factor - 1) >= 0.51) return "red: part of the exact or central pressure";
    return c.is_limited ? "red: central pressure" : "told: not limited: error of the central pressure";
  }
  if (name == "standing_wave" || name == "rotating_patch" || name == "dam_break")
    return factor < 0.05 || factor > 9 ? "red: pressure" : "open: within what is claimed of it";
  return "told: pressure: nothing";
}

struct Defect {
  std::string name, size;
  std::function<void(Data&, Generator&)> plant;
  Must must;
};

/// What must be said of whatever data.
Must always(const char* words) {
  return [words](const Planted&) { return words; };
}
Must of_velocity(const std::string& otherwise, const std::string& says = "") {
  return [=](const Planted& c) { return by_velocity(c, otherwise, says); };
}

// How they are planted.

void take(Samples& s, const std::vector<Index>& rows) {
  s = {s.time,
       s.x(Eigen::all, rows).eval(),
       s.v(Eigen::all, rows).eval(),
       s.mass(rows).eval(),
       s.density(rows).eval(),
       s.pressure(rows).eval()};
}

double part_of(const Planted& c) {
  double least = 1;
  for (std::size_t k = 0; k < c.right.levels.size(); ++k)
    least = std::min(least, 1 - static_cast<double>(c.planted.levels[k].back().size()) /
                                    static_cast<double>(c.right.levels[k].back().size()));
  return least;
}

Flow with(const Flow& flow, const std::string& name, double factor) {
  std::map<std::string, double> set;
  for (const Parameter& p : flow.parameters) set[p.name] = p.value * (p.name == name ? factor : 1);
  return flow_named(flow.name, Settings(set));
}

bool is_any(double part, Generator& random) { return std::uniform_real_distribution<double>()(random) < part; }

/// The defects of a flow, which lives longer, one after the other.
struct Defects {
  const Flow& flow;
  std::vector<Defect> all{};

  /// At each time; `change` may take a generator, too.
  void changed(const std::string& name, const std::string& size, Must must, auto change) {
    const auto plant = [=](Data& data, [[maybe_unused]] Generator& random) {
      for (std::vector<Samples>& level : data.levels)
        for (Samples& s : level)
          if constexpr (std::is_invocable_v<decltype(change), Samples&>)
            change(s);
          else
            change(s, random);
    };
    all.push_back({name, size, plant, std::move(must)});
  }

  /// The data of another answer, in the place of these.
  void answered(const std::string& name, const std::string& size, Must must, const Answer& answer) {
    const auto plant = [=, &flow = flow](Data& data, Generator& random) {
      data = data_of(flow, data.kind, data.levels.size(), static_cast<unsigned>(random() % 1000), answer);
    };
    all.push_back({name, size, plant, std::move(must)});
  }

  /// From each level the same rows at all times, or at the last alone: those of the first that are taken. `hole`: of
  /// the finest level, in spacings.
  void missing(const std::string& name, const std::string& size, double hole,
               const std::function<bool(const Samples&, Index, double spacing, Generator&)>& is_taken,
               bool at_last_only = false) {
    const auto plant = [=, &flow = flow](Data& data, Generator& random) {
      for (std::size_t k = 0; k < data.levels.size(); ++k) {
        std::vector<Index> kept;
        for (Index p = 0; p < data.levels[k][0].size(); ++p)
          if (!is_taken(data.levels[k][0], p, flow.across / data.across[k], random)) kept.push_back(p);
        for (Samples& s : data.levels[k])
          if (!at_last_only || &s == &data.levels[k].back()) take(s, kept);
      }
    };
    all.push_back(
        {name, size, plant, [=](const Planted& c) { return where_missing(c, part_of(c), hole, at_last_only); }});
  }
};

/// All that is planted into data of a flow.
std::vector<Defect> defects_of(const Flow& flow) {
  const std::string& name = flow.name;
  const bool is_at_rest = name == "hydrostatic", is_channel = flow.is_uniform_along_x;
  const bool moves = flow.has_free_surface() && !is_at_rest;  // its rows, and what is exact of it are their places
  const Vec2 middle = flow.filled.low + flow.filled.size().cwiseProduct(Vec2(0.43, 0.45));
  Defects to{flow};

  // Sound data.
  to.changed("none", "", always("green: sound"), [](Samples&) {});
  to.changed("rows in another order at each time", "", always("green: sound"), [](Samples& s, Generator& random) {
    std::vector<Index> rows(static_cast<std::size_t>(s.size()));
    std::iota(rows.begin(), rows.end(), 0);
    std::ranges::shuffle(rows, random);
    take(s, rows);
  });
  to.changed("single precision", "", always("green: sound"), [](Samples& s) {
    s.x = s.x.cast<float>().cast<double>().eval(), s.v = s.v.cast<float>().cast<double>().eval();
    s.pressure = s.pressure.cast<float>().cast<double>().eval();
  });
  to.answered("shaken by half a spacing", "", always("green: sound"), [&flow](Request r) {
    r.shaken *= 2;
    return right(flow, r);
  });

  // Rows that are missing.
  const auto at_random = [](double part) {
    return [=](const Samples&, Index, double, Generator& random) { return is_any(part, random); };
  };
  to.missing("rows missing", "one", 1, [=](const Samples& s, Index p, double, Generator&) {
    Index nearest;
    (s.x.colwise() - middle).colwise().norm().minCoeff(&nearest);
    return p == nearest;
  });
  to.missing("rows missing at random", "10 %", 1, at_random(0.1));
  to.missing("rows missing at random", "45 %", 1, at_random(0.45));
  to.missing("rows missing at random, at the last time", "10 %", 1, at_random(0.1), true);
  for (const double radius : {2.0, 3.0})
    to.missing("rows missing in a disc", fmt::format("{:g} spacings across", 2 * radius), 2 * radius,
               [=](const Samples& s, Index p, double spacing, Generator&) {
                 return (s.x.col(p) - middle).norm() < radius * spacing;
               });
  for (const int axis : {0, 1})
    to.missing(fmt::format("rows missing in a strip across {}", "xy"[axis]), "4 spacings", 4,
               [=](const Samples& s, Index p, double spacing, Generator&) {
                 return std::abs(s.x(axis, p) - middle[axis]) < 2.01 * spacing;
               });
  for (const double part : {0.3, 0.5, 0.9}) {
    const double at = flow.filled.high.y() - part * flow.filled.size().y();
    to.missing("upper part missing", fmt::format("{:g} %", 100 * part), 4,
               [=](const Samples& s, Index p, double, Generator&) { return s.x(1, p) > at; });
  }

  // Rows twice, or too near to one another.
  const auto twice = [&](const std::string& size, double part, Must must) {
    const auto plant = [=](Data& data, Generator& random) {
      for (std::vector<Samples>& level : data.levels) {
        const Index n = level[0].size();
        std::vector<Index> rows(static_cast<std::size_t>(n));
        std::iota(rows.begin(), rows.end(), 0);
        for (Index p = 0; p < n; ++p)
          if (part == 0 ? p == n / 2 : is_any(part, random)) rows.push_back(p);
        for (Samples& s : level) take(s, rows);
      }
    };
    to.all.push_back({"rows twice", size, plant, std::move(must)});
  };
  twice("one", 0, [](const Planted& c) {
    return c.has_particles()                 ? "red: in the place of another or refused"
           : c.flow.name == "rotating_patch" ? "open: its momentum is no longer that of all of it"
                                             : "green: less than 3 % of the volume";
  });
  for (const double part : {0.1, 1.0})
    twice(fmt::format("{:g} %", 100 * part), part, [](const Planted& c) {
      return c.has_particles() ? "red: in the place of another or refused" : "red: mass or refused";
    });
  const auto pair_up = [&flow](Data& data, Generator&) {
    for (std::size_t k = 0; k < data.levels.size(); ++k)
      for (Samples& s : data.levels[k]) {
        const Vec2 apart(0, flow.across / data.across[k] / 10);
        for (Index p = 1; p < s.size(); p += 2) s.x.col(p) = s.x.col(p - 1) + apart;
        set_exact_fields(flow, s);
      }
  };
  to.all.push_back({"rows in pairs", "a tenth of a spacing apart", pair_up, [](const Planted& c) {
                      return c.has_particles() ? "red: rows crowded or largest hole or empty places" : "";
                    }});

  // A velocity that is wrong.
  const auto velocity_times = [&](const std::string& what, double factor, const std::string& says = "") {
    to.changed(
        "velocity " + what, "",
        [=](const Planted& c) { return by_velocity(c, by_factor_of_velocity(c, factor), says); },
        [=](Samples& s) { s.v *= factor; });
  };
  velocity_times("at rest", 0, "at rest");
  velocity_times("reversed", -1, "wrong sign");
  velocity_times("times 0.97", 0.97);
  velocity_times("times 1.03", 1.03);
  velocity_times("times 2", 2);
  velocity_times("times 1e-3", 1e-3, "1000 times too small");
  velocity_times("times 10", 10, "10 times too large");
  velocity_times("times 1e3", 1e3, "1000 times too large");
  const bool is_followed = name == "standing_wave" || name == "dam_break";  // where its water goes by its velocity
  const char* by_motion = is_followed ? "red: part of the motion" : "red: ";
  const Must of_other_components = of_velocity(is_at_rest    ? "green: there is none"
                                               : is_followed ? by_motion
                                                             : "red: L2 or angular momentum");
  const Mat2 a_right_angle = (Mat2() << 0, -1, 1, 0).finished();
  to.changed("components of the velocity swapped", "", of_other_components,
             [](Samples& s) { s.v = s.v.colwise().reverse().eval(); });
  to.changed("velocity turned by 90°", "", of_other_components, [=](Samples& s) { s.v = a_right_angle * s.v.eval(); });
  to.changed("velocity with noise", "3 %", of_velocity("open: nothing is exact"), [](Samples& s, Generator& random) {
    std::normal_distribution<double> normal(0, 0.03 * std::sqrt(s.v.squaredNorm() / 2 / static_cast<double>(s.size())));
    for (double& v : s.v.reshaped()) v += normal(random);
  });
  for (const double wild : {10.0, 1e6})
    to.changed(
        "velocity of one row wild", fmt::format("{:g} times the largest", wild),
        [=](const Planted& c) {
          if (exact_of(c.flow, "velocity")) return "red: L2 or Linf or order";
          return wild > 100 || is_at_rest ? by_motion : "open: one of many";
        },
        [=](Samples& s) {
          const double scale = is_at_rest ? 3 : s.v.colwise().norm().maxCoeff();
          s.v.col(s.size() / 3) = wild * scale * Vec2(0.6, 0.8);
        });
  to.changed("velocity of one row no number", "", always(by_motion), [](Samples& s) { s.v(1, s.size() / 3) = NAN; });
  to.changed("half its velocity across it", "",
             of_velocity(is_at_rest    ? "green: there is none"
                         : is_followed ? "open: one component is right"
                                       : "red: "),
             [](Samples& s) { s.v.row(1) = s.v.row(0) / 2; });
  if (is_at_rest)
    to.changed("moving", "a tenth of sqrt(g h)", always("red: speed"), [](Samples& s) { s.v.setConstant(0.35); });

  // A pressure that is wrong.
  const auto pressure_times = [&](const std::string& what, double factor, const std::string& says = "") {
    to.changed(
        "pressure " + what, "",
        [=](const Planted& c) { return by_pressure(c, by_factor_of_pressure(c, factor), says); },
        [=](Samples& s) { s.pressure *= factor; });
  };
  pressure_times("zero", 0, "no pressure");
  pressure_times("reversed", -1, "wrong sign");
  pressure_times("times 1.03", 1.03);
  pressure_times("times 1e-3", 1e-3, "1000 times too small");
  pressure_times("times 1e3", 1e3, "1000 times too large");
  to.changed(
      "pressure of one row wild", "1e6 times the largest",
      [](const Planted& c) { return by_pressure(c, by_factor_of_pressure(c, 1e6)); },
      [](Samples& s) { s.pressure[s.size() / 3] = 1e6 * s.pressure.abs().maxCoeff() + 1; });
  to.changed(
      "pressure of one row no number", "",
      [](const Planted& c) {
        const std::string measured = by_factor_of_pressure(c, 0);
        return measured.starts_with("told") && !exact_of(c.flow, "pressure") ? measured : "red: nan";
      },
      [](Samples& s) { s.pressure[s.size() / 3] = NAN; });
  for (const bool is_mass : {false, true})
    to.changed(
        fmt::format("{} of one row no number", is_mass ? "mass" : "density"), "",
        [](const Planted& c) { return c.has_volumes() ? "red: expected a finite number" : ""; },
        [=](Samples& s) { (is_mass ? s.mass : s.density)[s.size() / 3] = NAN; });
  to.changed(
      "density", "5 % too large", [](const Planted& c) { return c.right.kind == Kind::weighed ? "red: density" : ""; },
      [](Samples& s) { s.density *= 1.05; });
  to.changed(
      "mass", "8 % too small", [](const Planted& c) { return c.has_volumes() ? "red: mass" : ""; },
      [](Samples& s) { s.mass *= 0.92; });

  // Places and times that are wrong.
  if (!is_at_rest && name != "cavity")
    to.answered("frozen at the start", "",
                of_velocity("red: ", moves ? "" : "nothing changes or at rest or late or too small"),
                [&flow](Request r) {
                  r.t = 0;
                  return right(flow, r);
                });
  for (const double late : {0.9, 2.0})
    if (!is_at_rest && name != "cavity")
      to.answered(
          late < 1 ? "late" : "twice as fast", late < 1 ? "10 % of the time" : "",
          [=](const Planted& c) -> std::string {
            if (name == "dam_break" && late < 1) return "open: clocks of experiments differ";
            if (name == "rotating_patch" && late < 1 && c.right.levels.size() == 1)
              return "open: corners are known to five spacings";
            return name == "elliptic_drop" ? "red: " : by_velocity(c, "red: ");
          },
          [=, &flow](Request r) {
            r.t *= late;
            Samples s = right(flow, r);
            if (late > 1 && moves) s.v *= 2;
            return s;
          });
  const auto swap_times = [](Data& data, Generator&) {
    for (std::vector<Samples>& level : data.levels) {
      std::swap(level.front(), level.back());
      std::swap(level.front().time, level.back().time);
    }
  };
  to.all.push_back({"first and last time swapped", "", swap_times, [=](const Planted& c) -> std::string {
                      if (name == "hydrostatic" || name == "cavity") return "green: it is steady";
                      if (name == "standing_wave") return "open: two of many times";
                      return name == "elliptic_drop" ? "red: " : by_velocity(c, "red: ");
                    }});
  const auto swap_levels = [](Data& data, Generator&) {
    data.is_said = true;
    std::swap(data.levels.front(), data.levels.back());
  };
  to.all.push_back({"coarsest and finest resolution swapped", "", swap_levels, [](const Planted& c) {
                      if (c.right.levels.size() == 1) return "";
                      if (c.has_particles()) return "red: rows or largest hole or order or refused";
                      return exact_of(c.flow, "velocity") && c.flow.name != "elliptic_drop" ? "red: order"
                                                                                            : "open: rows of a mesh";
                    }});
  for (const int axis : {0, 1})
    to.changed(
        fmt::format("mirrored along {}", "xy"[axis]), "",
        [=](const Planted& c) -> std::string {
          if (is_at_rest) return by_pressure(c, "", "mirrored or too small");
          if (name == "standing_wave") return axis == 0 ? "green: it is symmetric" : "red: ";
          if (name == "rotating_patch") return "red: angular momentum";
          if (name == "dam_break") return axis == 0 ? "red: " : "open: nothing is exact of its pressure";
          return by_velocity(c, "red: ", "mirrored or wrong sign or shifted or swapped");
        },
        [=, &flow](Samples& s) {
          const Box& box = flow.filled;
          double high = box.high[axis];  // of the fluid, where it reaches from a wall to its surface
          if (flow.has_free_surface() && box.low[axis] == flow.domain.box.low[axis] && !flow.domain.periodic(axis))
            high = name == "dam_break" && axis == 0 ? flow.domain.box.high.x() : s.x.row(axis).maxCoeff();
          s.x.row(axis) = (box.low[axis] + high - s.x.row(axis).array()).matrix();
          s.v.row(axis) *= -1;
        });
  if (std::abs(flow.filled.size().x() / flow.filled.size().y() - 1) < 1e-9 && name != "dam_break")
    to.changed("turned by 90°", "",
               name == "elliptic_drop" ? always("red: ")
                                       : of_velocity(name == "rotating_patch" ? "green: it is symmetric" : "red: "),
               [=, at = Vec2((flow.filled.low + flow.filled.high) / 2)](Samples& s) {
                 s.x = (a_right_angle * (s.x.colwise() - at)).colwise() + at;
                 s.v = a_right_angle * s.v.eval();
               });
  for (const int axis : {0, 1})
    to.changed(
        fmt::format("shifted along {}", "xy"[axis]), "a quarter",
        [=](const Planted& c) -> std::string {
          if (!c.flow.domain.periodic(axis))
            return name == "rotating_patch" || name == "elliptic_drop" || c.flow.has_free_surface()
                       ? "red: "
                       : "red: outside the domain";
          if (is_at_rest) return "green: it is uniform along x";
          if (name == "standing_wave") return "red: amplitude over that of the wave";
          return by_velocity(c, "red: ", "shifted or mirrored or wrong sign or swapped or places");
        },
        [=, &flow](Samples& s) {
          s.x.row(axis).array() += flow.filled.size()[axis] / 4;
          for (Index p = 0; p < s.size(); ++p)
            for (const int k : {0, 1}) s.x(k, p) = flow.domain.wrapped(k, s.x(k, p));
        });
  to.changed("places", "1000 times too large", always("red: outside the domain or the rows span"), [](Samples& s) {
    s.x *= 1000;
    s.mass *= 1e6;
  });

  // Another flow, or other parameters.
  const auto of_another = [&flow](const Flow& other) {
    return [=, &flow](Request r) {
      r.across *= other.across / flow.across;
      return right(other, r);
    };
  };
  const auto times = [&](const std::string& which, double factor) {
    if (std::ranges::find(flow.parameters, which, &Parameter::name) == flow.parameters.end()) return;
    if (name == "cavity" && which == "Re") return;
    to.answered(
        fmt::format("{} times {:g}", which, factor), "",
        [=](const Planted& c) -> std::string {
          if (name == "dam_break" && which == "L") return "green: the far wall is not reached";
          if (name == "dam_break" && which == "H") return "green: the top is not reached";
          if (is_channel && which == "L") return "open: it is uniform along x";
          if (which == "H" || which == "L" || which == "h" || which == "R" || which == "l0") return "red: ";
          if (name == "standing_wave" && which == "nu") return "open: to first order in it";
          if (name == "hydrostatic") return by_pressure(c, "");
          if (name == "cavity" && !c.is_limited && std::abs(factor - 1) < 0.15) return "open: about what is claimed";
          if (name == "elliptic_drop" || name == "rotating_patch" || name == "standing_wave" || name == "dam_break" ||
              name == "cavity")
            return "red: ";
          return by_velocity(c, "red: ");
        },
        of_another(with(flow, which, factor)));
  };
  for (const char* which : {"F", "g"})
    for (const double factor : {0.6, 1.2}) times(which, factor);
  for (const char* which : {"nu", "Re", "V", "U", "period", "omega", "s", "H", "L"}) times(which, 1.1);
  times("h", 1.2);
  times("R", 1.1);
  times("l0", 1.3);
  if (name == "cavity") to.answered("Re 400 for 100", "", always("red: L2 v"), of_another(with(flow, "Re", 4)));
  static const std::map<std::string, std::string> mistaken{{"poiseuille", "couette"},
                                                           {"couette", "poiseuille"},
                                                           {"oscillating_poiseuille", "stokes_second"},
                                                           {"stokes_first", "couette"},
                                                           {"stokes_second", "couette"},
                                                           {"taylor_green", "shear_wave"},
                                                           {"shear_wave", "taylor_green"},
                                                           {"manufactured", "taylor_green"},
                                                           {"cavity", "taylor_green"},
                                                           {"hydrostatic", "standing_wave"},
                                                           {"standing_wave", "hydrostatic"},
                                                           {"elliptic_drop", "rotating_patch"},
                                                           {"rotating_patch", "elliptic_drop"},
                                                           {"dam_break", "hydrostatic"}};
  to.answered("of " + mistaken.at(name), "", always("red: "),
              [&flow, other = flow_named(mistaken.at(name))](Request r) {
                r.across = std::max(8.0, std::round(r.across * other.across / flow.across));
                return right(other, r);
              });
  if (is_channel)
    for (const double out : {0.05, -0.05})
      to.answered(fmt::format("walls {}", out > 0 ? "out" : "in"), "5 % of the gap", of_velocity("red: "),
                  [=, &flow](const Request& r) {
                    Changes by;
                    by(Cause::floor) = out * flow.across;
                    Samples s = right(flow, r);
                    const FieldTruth moved = flow.exact[0].with(by);
                    for (Index p = 0; p < s.size(); ++p) s.v.col(p) = moved(s.x.col(p), r.t);
                    return s;
                  });
  if (name == "dam_break")
    to.changed("running backwards", "", always("red: front or spread over"), [](Samples& s) {
      const double front = s.x.row(0).maxCoeff() / 0.6;
      s.x.row(0) /= front * front, s.x.row(1) *= std::min(front * front, 1.9);
    });
  return std::move(to.all);
}

bool has_any(const std::string& text, std::string_view words) {
  for (std::size_t begin = 0; begin <= words.size();) {
    const std::size_t end = std::min(words.find(" or ", begin), words.size());
    if (text.find(words.substr(begin, end - begin)) != text.npos) return true;
    begin = end + 4;
  }
  return false;
}

/// Whether it is as it must be.
bool is_as(const std::string& must, const Said& said) {
  const std::size_t colon = must.find(": "), also = must.find("; says: ");
  const std::string kind = must.substr(0, colon),
                    words = must.substr(colon + 2, also == must.npos ? also : also - colon - 2);
  if (kind == "open") return true;
  if (kind == "green") return said.red.empty();
  if (kind == "told") return !said.red.empty() || has_any(said.told, words);
  return !said.red.empty() && has_any(said.complaints, words) &&
         (also == must.npos || has_any(said.complaints, must.substr(also + 8)));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Plants defects into right data of every flow, and says of which the judge does not say what it must.",
               "touchstone_defects"};
  std::string only;
  unsigned seed = 1;
  bool at_night = false, prints_all = false, explains = false;
  app.add_option("--only", only, "of what stands in a row of the table: flow, defect, size, data, levels");
  app.add_option("--seed", seed, "of random rows and noise")->check(programs::numbers());
  app.add_flag("--night", at_night, "all kinds of data, not one of each defect in turn");
  app.add_flag("--all", prints_all, "rows of what is as it must be, too");
  app.add_flag("--explain", explains, "with all that was said");
  CLI11_PARSE(app, argc, argv);
  const auto begin = std::chrono::steady_clock::now();
  std::map<std::string, long> counts;
  long judged = 0, wrong = 0;
  std::size_t turn = 0;  // by day each defect is in the next kind of data, at three levels: an odd k
  fmt::print("| flow | defect | size | data | must be | is |\n| --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : flow_names()) {
    const Flow flow = flow_named(name);
    for (const Defect& defect : defects_of(flow))
      for (std::size_t k = 0, by_day = 7 * turn++ % (2 * kinds.size()) / 2 * 2 + 1; k < 2 * kinds.size(); ++k) {
        const auto& [kind, kind_name] = kinds[k % kinds.size()];
        const std::size_t levels = k % 2 == 0 ? 1 : 3;
        if (!at_night && k != by_day) continue;
        const bool has_limit = levels == 1 && name != "dam_break" && name != "rotating_patch";  // none is within 1 %
        const std::string row = fmt::format("| {} | {} | {} | {}, {} |", name, defect.name, defect.size, kind_name,
                                            has_limit     ? "one level, --at-most 1"
                                            : levels == 1 ? "one level"
                                                          : "three levels");
        if (row.find(only) == row.npos) continue;
        const Data sound = data_of(flow, kind, levels, seed, [&](const Request& r) { return right(flow, r); });
        Data planted = sound;
        Generator random(seed);
        defect.plant(planted, random);
        const Planted one{flow, sound, planted, has_limit};
        const std::string must = defect.must(one);
        if (must.empty()) continue;
        const Said said = said_of(flow, planted, has_limit);
        ++judged;
        const bool is_right = is_as(must, said);
        wrong += !is_right;
        ++counts[must.substr(0, must.find(':')) + (said.red.empty() ? ", not red" : ", red")];
        if (is_right && !prints_all) continue;
        fmt::print("{} {} | {}{} |\n", row, must, is_right ? "" : "WRONG ",
                   said.red.empty() ? "green" : fmt::format("red: {}", fmt::join(said.red, ", ")));
        if (explains) fmt::print("{}--\n{}\n", said.complaints, said.told);
        std::fflush(stdout);
      }
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  std::string all;
  for (const auto& [what, count] : counts) all += fmt::format("; {} {}", count, what);
  fmt::print("{} judgements in {:.0f} s, seed {}{}: {} not as they must be\n", judged, taken.count(), seed, all, wrong);
  return wrong == 0 && judged > 0 ? 0 : 1;
}
