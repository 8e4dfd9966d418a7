#pragma once
/// One flow in several views: mirrored, turned, carried along, from another lattice. What is the same to physics should
/// be the same to a method.

#include "vnv/case.hpp"
#include "vnv/measures/field_errors.hpp"

#include <functional>
#include <string>
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
  /// The start of a flow that starts so in the plain view.
  Start start(const Start& plain) const;
  template <class AnyScene>
  AnyScene scene(AnyScene plain) const {
    plain.start = start(plain.start);
    return plain;
  }
  Vectors places_on(const Vectors& lattice) const { return rearranged ? rearranged(lattice) : lattice; }

  /// The particles of a run in this view, as they would be in the plain flow.
  Samples in_plain_flow(Samples s) const;
};

namespace views {

View plain();
View mirrored(const Mat2& by, const Vec2& centre);
/// Left and right change places, about a line x = constant [m].
View mirrored_about_x(double x);
/// Above and below change places, about a line y = constant [m].
View mirrored_about_y(double y);
View carried_along(const Vec2& velocity);
View turned(const Mat2& by);
/// Each particle starts up to so far [m] off its place along each axis.
View on_disturbed_lattice(double by);
/// The particles in another order, the same every time.
View numbered_anew();

}  // namespace views

/// One flow at one resolution in several views, and the error that should not change with them.
struct SeveralViews {
  std::vector<View> views;  // the first is the plain flow
  double spacing, cell;     // m
  double end;               // s  when all are evaluated
  Quantity error;

  /// The view of a level; the plain flow for a run at any resolution.
  const View& of(const Level& level) const;

  std::vector<Level> levels() const;

  /// What is measured of the plain flow, measured of all.
  Measurement measured(Measurement of_plain_flow) const;

  /// By how much each view changes the error of the plain flow.
  Quantity change() const;
  Finding changes() const;

  /// One row a method; `words` say what the transformations are.
  Plot table(const std::string& words) const;

  /// All of a case but what it monitors; `words` say what the transformations are.
  Case declared(std::string title, std::string description, const Measurement& of_plain_flow,
                std::vector<Method> methods_in_views, const std::string& words) const;

  /// Methods, which `methods_on` makes for a scene, in all views; `scene_of` makes the scene of a view. Those that are
  /// `galilean` by name claim to see no difference where all is carried along.
  template <class SceneOf, class MethodsOn>
  std::vector<Method> methods(const SceneOf& scene_of, const MethodsOn& methods_on,
                              const std::vector<std::string>& galilean = {}) const {
    return in_all_views([=](const View& view) { return methods_on(scene_of(view)); }, galilean);
  }

  /// The claim that the error in a view is that of the plain flow.
  Claim unchanged(const View& view, const std::string& why) const;

 private:
  std::vector<Method> in_all_views(const std::function<std::vector<Method>(const View&)>& methods_in,
                                   const std::vector<std::string>& galilean) const;
  std::vector<Claim> claims_of_all() const;  // what every method claims
  double error_in(const View& view, const Results& results, const Record& record) const;
};

/// The plain flow, these transformations, a disturbed lattice and renumbered particles; in MPM four particles a cell.
SeveralViews several_views(std::vector<View> transformed, double spacing, double end, const Quantity& error);

}  // namespace touchstone::vnv
