#pragma once
/// One flow in several views: mirrored, turned, carried along, from another lattice. What is the same to physics should
/// be the same to a method.

#include "vnv/case.hpp"
#include "vnv/measures/field_errors.hpp"
#include "vnv/plots/along_ladders.hpp"
#include "vnv/studies/disturbed.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::vnv {

/// A flow as another observer sees it, or on other particles.
struct View {
  std::string name;
  Mat2 turned = Mat2::Identity();                               // or mirrored, about `centre`
  Vec2 centre = Vec2::Zero();                                   // m
  Vec2 carried = Vec2::Zero();                                  // m/s
  std::function<Vectors(const Vectors& lattice)> rearranged{};  // where the particles do not start on the lattice
  std::string theory{};  // why no method may see a difference; empty where one may

  /// Where the plain flow has what this view has at a place [m] and a time [s].
  Vec2 place_in_plain_flow(const Vec2& x, double t) const {
    return centre + turned.transpose() * (x - centre - t * carried);
  }
  Vec2 velocity(const VelocityTruth& plain, const Vec2& x, double t) const {
    return carried + turned * plain(place_in_plain_flow(x, t), t);
  }
  double pressure(const PressureTruth& plain, const Vec2& x, double t) const {
    return plain(place_in_plain_flow(x, t), t);
  }
  /// The start of a flow on its lattice.
  Start start(const VelocityTruth& v, const PressureTruth& p) const {
    return {.velocity = [v, view = *this](const Vec2& x) { return view.velocity(v, x, 0); },
            .pressure = [p, view = *this](const Vec2& x) { return view.pressure(p, x, 0); },
            .places = rearranged};
  }
  Vectors places_on(const Vectors& lattice) const { return rearranged ? rearranged(lattice) : lattice; }

  /// The particles of a run in this view, as they would be in the plain flow.
  Samples in_plain_flow(Samples s) const {
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      s.x.col(p) = place_in_plain_flow(s.x.col(p), s.time);
      s.v.col(p) = turned.transpose() * (s.v.col(p) - carried);
    }
    return s;
  }
};

namespace views {

inline View plain() { return {.name = "plain"}; }
inline View mirrored(const Mat2& by, const Vec2& centre) {
  return {.name = "mirrored", .turned = by, .centre = centre, .theory = "mirror symmetry"};
}
/// Left and right change places, about a line x = constant [m].
inline View mirrored_about_x(double x) { return mirrored(Vec2(-1, 1).asDiagonal(), {x, 0}); }
/// Above and below change places, about a line y = constant [m].
inline View mirrored_about_y(double y) { return mirrored(Vec2(1, -1).asDiagonal(), {0, y}); }
inline View carried_along(const Vec2& velocity) { return {.name = "carried along", .carried = velocity}; }
inline View turned(const Mat2& by) { return {.name = "turned", .turned = by}; }
/// Each particle starts up to so far [m] off its place along each axis.
inline View on_disturbed_lattice(double by) {
  return {.name = "disturbed lattice", .rearranged = [by](const Vectors& lattice) { return disturbed(lattice, by); }};
}
/// The particles in another order, the same every time.
inline View numbered_anew() {
  return {.name = "numbered anew",
          .rearranged = [](const Vectors& lattice) -> Vectors {
            std::mt19937_64 random(20);
            std::vector<Eigen::Index> order(static_cast<std::size_t>(lattice.cols()));
            std::iota(order.begin(), order.end(), 0);
            for (std::size_t k = order.size() - 1; k > 0; --k) std::swap(order[k], order[random() % (k + 1)]);
            return lattice(Eigen::all, order);
          },
          .theory = "particle numbering is arbitrary"};
}

}  // namespace views

/// One flow at one resolution in several views, and the error that should not change with them.
struct SeveralViews {
  std::vector<View> views;  // the first is the plain flow
  double spacing, cell;     // m
  double end;               // s  when all are evaluated
  Quantity error;

  /// The view of a level; the plain flow for a run at any resolution.
  const View& of(const Level& level) const {
    const auto named = std::ranges::find(views, level.name, &View::name);
    return named == views.end() ? views.front() : *named;
  }

  std::vector<Level> levels() const {
    std::vector<Level> all;
    for (const View& view : views)
      all.push_back({.name = view.name, .spacing = spacing, .cell = cell, .acceptance = end, .nightly = end});
    return all;
  }

  /// What is measured of the plain flow, measured of all.
  Measurement measured(Measurement of_plain_flow) const {
    return [=, *this](const Level& level, const Run& run) {
      Run seen = run;
      for (Samples& s : seen.samples) s = of(level).in_plain_flow(std::move(s));
      return of_plain_flow(level, seen);
    };
  }

  /// By how much each view changes the error of the plain flow.
  Quantity change() const { return {"change of the error relative to the untransformed flow", "%", Kind::deviation}; }
  Finding changes() const {
    return [*this](const Results& results, const Record& record) {
      const double in_plain_flow = error_in(views.front(), results, record);
      std::vector<Value> found;
      for (const View& view : std::span(views).subspan(1))
        found.push_back(
            {view.name, spacing, end, change(), 100 * (error_in(view, results, record) / in_plain_flow - 1)});
      return found;
    };
  }

  /// One row a method; `words` say what the transformations are.
  Plot table(const std::string& words) const {
    return [*this, words](const Results& results, Record& record) {
      Table table{
          "views",
          "The same flow under symmetry transformations",
          fmt::format("\"{}\" at t = {:g} s. {} Disturbed lattice: each particle is initially displaced by up to "
                      "a tenth of a spacing.",
                      error.heading(), end, words),
          {"method"},
          {}};
      std::vector<Cell> row{results.method.name};
      for (const View& view : views) {
        table.columns.push_back(view.name);
        row.emplace_back(error_in(view, results, record));
      }
      table.rows.push_back(std::move(row));
      record.tables.push_back(std::move(table));
    };
  }

  /// All of a case but its words and what it monitors; `words` say what the transformations are.
  Case declared(const Measurement& of_plain_flow, std::vector<Method> methods_in_views,
                const std::string& words) const {
    return {.times = {end},
            .measurements = {measured(of_plain_flow)},
            .findings = {changes()},
            .claims = claims_of_all(),
            .methods = std::move(methods_in_views),
            .plots = {table(words)}};
  }

  Claim unchanged(const View& view, const std::string& why) const {
    return between(change(), -1, 1, theory(why)).on(view.name).at(end);
  }
  /// What every method claims.
  std::vector<Claim> claims_of_all() const {
    std::vector<Claim> all;
    for (const View& view : views)
      if (!view.theory.empty()) all.push_back(unchanged(view, view.theory));
    return all;
  }

  /// Methods, which `methods_on` makes for a scene, in all views; `scene_of` makes the scene of a view. Those that are
  /// `galilean` by name claim to see no difference where all is carried along.
  template <class SceneOf, class MethodsOn>
  std::vector<Method> methods(const SceneOf& scene_of, const MethodsOn& methods_on,
                              const std::vector<std::string>& galilean = {}) const {
    std::vector<Method> all = methods_on(scene_of(views.front()));
    for (std::size_t k = 0; k < all.size(); ++k) {
      Method& method = all[k];
      method.run = [=, *this](const Level& level, const Schedule& when) {
        const Method in_view = methods_on(scene_of(of(level)))[k];
        // In the same steps: one that followed the flow would be shorter where all is carried along.
        Level in_equal_steps = level;
        if (in_view.time_step) in_equal_steps.time_step = level.step_or(in_view.time_step(level));
        return in_view.run(in_equal_steps, when);
      };
      method.levels = levels();
      if (std::ranges::find(galilean, method.name) == galilean.end()) continue;
      for (const View& view : views)
        if (view.carried != Vec2::Zero())
          method.claims.push_back(
              unchanged(view, "Galilean invariance: only differences of velocity and position enter"));
    }
    return all;
  }

 private:
  double error_in(const View& view, const Results& results, const Record& record) const {
    const Run* run = results.run(view.name);
    return run ? error_of(error, end)(record, *run).value_or(not_a_number) : not_a_number;
  }
};

/// The plain flow, these transformations, a disturbed lattice and renumbered particles; in MPM four particles a cell.
inline SeveralViews several_views(std::vector<View> transformed, double spacing, double end, const Quantity& error) {
  transformed.insert(transformed.begin(), views::plain());
  transformed.push_back(views::on_disturbed_lattice(0.1 * spacing));
  transformed.push_back(views::numbered_anew());
  return {.views = std::move(transformed), .spacing = spacing, .cell = 2 * spacing, .end = end, .error = error};
}

}  // namespace touchstone::vnv
