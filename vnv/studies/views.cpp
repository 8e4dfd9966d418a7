#include "vnv/studies/views.hpp"

#include "vnv/measures/plots/along_ladders.hpp"
#include "vnv/record/record.hpp"
#include "vnv/studies/starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <span>
#include <utility>

namespace touchstone::vnv {

Start View::start(const Start& plain) const {
  return {.velocity = [=, *this](const Vec2& x) -> Vec2 {
            return carried + turned * plain.velocity_at(place_in_plain_flow(x, 0));
          },
          .pressure = [=, *this](const Vec2& x) { return plain.pressure_at(place_in_plain_flow(x, 0)); },
          .places = [=, *this](const Vectors& lattice) { return places_on(plain.places_on(lattice)); }};
}

Samples View::in_plain_flow(Samples s) const {
  for (Eigen::Index p = 0; p < s.size(); ++p) {
    s.x.col(p) = place_in_plain_flow(s.x.col(p), s.time);
    s.v.col(p) = turned.transpose() * (s.v.col(p) - carried);
  }
  return s;
}

View views::plain() { return {.name = "plain"}; }
View views::mirrored(const Mat2& by, const Vec2& centre) {
  return {.name = "mirrored", .turned = by, .centre = centre, .theory = "mirror symmetry"};
}
View views::mirrored_about_x(double x) { return mirrored(Vec2(-1, 1).asDiagonal(), {x, 0}); }
View views::mirrored_about_y(double y) { return mirrored(Vec2(1, -1).asDiagonal(), {0, y}); }
View views::carried_along(const Vec2& velocity) { return {.name = "carried along", .carried = velocity}; }
View views::turned(const Mat2& by) { return {.name = "turned", .turned = by}; }
View views::on_disturbed_lattice(double by) {
  return {.name = "disturbed lattice", .rearranged = [by](const Vectors& lattice) { return disturbed(lattice, by); }};
}
View views::numbered_anew() {
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

const View& SeveralViews::of(const Level& level) const {
  const auto named = std::ranges::find(views, level.name, &View::name);
  return named == views.end() ? views.front() : *named;
}

std::vector<Level> SeveralViews::levels() const {
  std::vector<Level> all;
  for (const View& view : views)
    all.push_back({.name = view.name, .spacing = spacing, .cell = cell, .acceptance = end, .nightly = end});
  return all;
}

Measurement SeveralViews::measured(Measurement of_plain_flow) const {
  return [=, *this](const Level& level, const Run& run) {
    Run seen = run;
    for (Samples& s : seen.samples) s = of(level).in_plain_flow(std::move(s));
    return of_plain_flow(level, seen);
  };
}

Quantity SeveralViews::change() const {
  return {"change of the error relative to the untransformed flow", "%", Kind::deviation};
}

Finding SeveralViews::changes() const {
  return [*this](const Results& results, const Record& record) {
    const double in_plain_flow = error_in(views.front(), results, record);
    std::vector<Value> found;
    for (const View& view : std::span(views).subspan(1))
      found.push_back({view.name, spacing, end, change(), 100 * (error_in(view, results, record) / in_plain_flow - 1)});
    return found;
  };
}

Plot SeveralViews::table(const std::string& words) const {
  return [*this, words](const Results& results, Record& record) {
    Table table{"views",
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

Case SeveralViews::declared(std::string title, std::string description, const Measurement& of_plain_flow,
                            std::vector<Method> methods_in_views, const std::string& words) const {
  return {.title = std::move(title),
          .description = std::move(description),
          .times = {end},
          .measurements = {measured(of_plain_flow)},
          .findings = {changes()},
          .claims = claims_of_all(),
          .methods = std::move(methods_in_views),
          .plots = {table(words)}};
}

Claim SeveralViews::unchanged(const View& view, const std::string& why) const {
  return between(change(), -1, 1, theory(why)).on(view.name).at(end);
}

std::vector<Claim> SeveralViews::claims_of_all() const {
  std::vector<Claim> all;
  for (const View& view : views)
    if (!view.theory.empty()) all.push_back(unchanged(view, view.theory));
  return all;
}

std::vector<Method> SeveralViews::in_all_views(const std::function<std::vector<Method>(const View&)>& methods_in,
                                               const std::vector<std::string>& galilean) const {
  std::vector<Method> all = methods_in(views.front());
  for (std::size_t k = 0; k < all.size(); ++k) {
    Method& method = all[k];
    method.run = [=, *this](const Level& level, const Schedule& when) {
      const Method in_view = methods_in(of(level))[k];
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

double SeveralViews::error_in(const View& view, const Results& results, const Record& record) const {
  const Run* run = results.run(view.name);
  return run ? error_of(error, end)(record, *run).value_or(not_a_number) : not_a_number;
}

SeveralViews several_views(std::vector<View> transformed, double spacing, double end, const Quantity& error) {
  transformed.insert(transformed.begin(), views::plain());
  transformed.push_back(views::on_disturbed_lattice(0.1 * spacing));
  transformed.push_back(views::numbered_anew());
  return {.views = std::move(transformed), .spacing = spacing, .cell = 2 * spacing, .end = end, .error = error};
}

}  // namespace touchstone::vnv
