#include "vnv/studies/views.hpp"

#include <gtest/gtest.h>

namespace touchstone::vnv {
namespace {

/// A flow without any symmetry.
Vec2 flow(const Vec2& x, double t) { return {x.x() + 2 * x.y() * x.y() + t, 3 * x.x() * x.y() - t * t}; }

const View oblique{.name = "oblique",
                   .turned = Eigen::Rotation2Dd(0.4).toRotationMatrix(),
                   .centre = {0.3, -0.2},
                   .carried = {0.7, 0.1}};

Samples seen_in(const View& view, double t) {
  Samples s;
  s.time = t;
  s.x = Vectors{{0.1, 0.5, -0.3}, {0.2, -0.4, 0.6}};
  s.v = s.x;
  for (Eigen::Index p = 0; p < s.x.cols(); ++p) s.v.col(p) = view.velocity(flow, s.x.col(p), t);
  return s;
}

void expect_plain_flow_behind(const View& view) {
  const Samples plain = view.in_plain_flow(seen_in(view, 0.8));
  for (Eigen::Index p = 0; p < plain.x.cols(); ++p)
    EXPECT_LT((plain.v.col(p) - flow(plain.x.col(p), 0.8)).norm(), 1e-14) << view.name << ", particle " << p;
}

TEST(Views, UndoneAreThePlainFlow) {
  expect_plain_flow_behind(views::plain());
  expect_plain_flow_behind(oblique);
  expect_plain_flow_behind(views::mirrored_about_x(0.2));
  expect_plain_flow_behind(views::mirrored_about_y(-0.1));
}

TEST(Views, AViewThatIsMirroredTurnsVelocitiesAndLeavesItsLineWhereItIs) {
  const View mirrored = views::mirrored_about_x(0.5);
  const Vec2 on_line(0.5, 0.7);
  EXPECT_EQ(mirrored.place_in_plain_flow(on_line, 0), on_line);
  EXPECT_EQ(mirrored.place_in_plain_flow({0.75, 0.7}, 0), Vec2(0.25, 0.7));
  EXPECT_EQ(mirrored.velocity(flow, on_line, 0), Vec2(-flow(on_line, 0).x(), flow(on_line, 0).y()));
}

TEST(Views, WhoIsCarriedAlongSeesThePlainFlowPassBy) {
  const View carried = views::carried_along({2, 0});
  EXPECT_EQ(carried.velocity(flow, {1, 1}, 0.5), Vec2(2, 0) + flow({0, 1}, 0.5));
}

TEST(Views, NumberedAnewThePlacesAreTheSame) {
  Vectors lattice(2, 50);
  for (Eigen::Index p = 0; p < lattice.cols(); ++p) lattice.col(p) = Vec2(static_cast<double>(p), 1);
  const Vectors anew = views::numbered_anew().places_on(lattice);
  std::vector<double> places(anew.row(0).begin(), anew.row(0).end());
  EXPECT_FALSE(std::ranges::is_sorted(places));
  std::ranges::sort(places);
  for (std::size_t p = 0; p < places.size(); ++p) EXPECT_EQ(places[p], static_cast<double>(p));
}

TEST(Views, ARunAtAnyResolutionIsOfThePlainFlow) {
  const SeveralViews flows{
      .views = {views::plain(), views::mirrored_about_x(0)}, .spacing = 1, .cell = 2, .end = 1, .error = {"e"}};
  EXPECT_EQ(flows.of({.name = "mirrored", .spacing = 1}).name, "mirrored");
  EXPECT_EQ(flows.of({.name = "", .spacing = 1}).name, "plain");
}

TEST(Views, TheChangeIsToldInPerCentOfTheErrorOfThePlainFlow) {
  const SeveralViews flows{
      .views = {views::plain(), views::mirrored_about_x(0)}, .spacing = 1, .cell = 2, .end = 1, .error = {"e"}};
  const Method method{.name = "m", .levels = flows.levels()};
  Record record;
  Results results{method, Suite::acceptance, {}};
  for (const auto& [level, error] : {std::pair{"plain", 2.0}, std::pair{"mirrored", 2.5}}) {
    vnv::Run run;
    run.summary.level = level;
    results.runs.push_back(run);
    record.values.push_back({level, 1, 1, {"e"}, error});
  }
  const std::vector<Value> found = flows.changes()(results, record);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].level, "mirrored");
  EXPECT_DOUBLE_EQ(found[0].value, 25);
}

}  // namespace
}  // namespace touchstone::vnv
