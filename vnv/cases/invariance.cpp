/// Taylor-Green vortices that are mirrored, carried along, turned, on a disturbed lattice and with particles numbered
/// anew: what is the same flow to physics should be the same to a method.

#include "vnv/disturbed.hpp"
#include "vnv/taylor_green.hpp"

#include <numeric>
#include <random>

using namespace touchstone;
using namespace touchstone::vnv;
using namespace touchstone::vnv::square;

namespace {

constexpr double end = 0.2;  // s
constexpr taylor_green::Flow flow{.reynolds = 100, .sound_speed = 10};
constexpr int particles_across = 34;  // of these 2.236 times as many are a whole number, and so are those of the cells

Vectors renumbered(const Vectors& lattice) {
  std::mt19937_64 random(20);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(lattice.cols()));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = order.size() - 1; k > 0; --k) std::swap(order[k], order[random() % (k + 1)]);
  return lattice(Eigen::all, order);
}

/// The same flow as another observer sees it, or on other particles.
struct Variant {
  std::string name;
  Mat2 turned = Mat2::Identity();
  Vec2 carried = Vec2::Zero();                              // m/s
  double period = side;                                     // m  of the square that repeats
  std::function<Vectors(const Vectors& lattice)> places{};  // where not on the lattice

  Vec2 velocity(const Vec2& x, double t) const { return carried + turned * flow.velocity()(seen_from(x, t), t); }
  double pressure(const Vec2& x, double t) const { return flow.pressure()(seen_from(x, t), t); }
  Scene<Newtonian> scene() const {
    const Box square{.high = {period, period}};
    return {.domain = {.box = square, .periodic_x = true, .periodic_y = true},
            .fluid = flow.fluid(),
            .filled = square,
            .start = {.velocity = [v = *this](const Vec2& x) { return v.velocity(x, 0); },
                      .pressure = [v = *this](const Vec2& x) { return v.pressure(x, 0); },
                      .places = places}};
  }

 private:
  Vec2 seen_from(const Vec2& x, double t) const { return turned.transpose() * (x - t * carried); }
};

Mat2 mirror() { return Vec2(-1, 1).asDiagonal(); }
/// By the angle of the direction (2, 1), 26.6 degrees: the only one below 30 degrees for which a square of less than
/// ten periods repeats.
Mat2 oblique() { return (Mat2() << 2, -1, 1, 2).finished() / std::sqrt(5); }

const std::string plain = "plain", mirrored = "mirrored", carried = "carried along", turned = "turned",
                  on_disturbed_lattice = "disturbed lattice", numbered_anew = "numbered anew";

const std::vector<Variant> variants = {
    {.name = plain},
    {.name = mirrored, .turned = mirror()},
    {.name = carried, .carried = {1, 0.5}},
    {.name = turned, .turned = oblique(), .period = std::sqrt(5) * side},
    {.name = on_disturbed_lattice,
     .places = [](const Vectors& lattice) { return disturbed(lattice, 0.1 * side / particles_across); }},
    {.name = numbered_anew, .places = renumbered}};

const Variant& variant(const std::string& rung) { return *std::ranges::find(variants, rung, &Variant::name); }

const std::string error = "L2 v, as it is for one who is carried along [%]";
const std::string change = "change of the L2 error of v [%]";

std::vector<Error> error_seen_at_rest(const Rung& rung, const Run& run) {
  const Variant& of_run = variant(rung.name);
  std::vector<Error> errors;
  for (const Samples& s : run.samples) {
    double squares = 0, scale = 0;
    for (Eigen::Index p = 0; p < s.size(); ++p) {
      const Vec2 exact = of_run.velocity(s.x.col(p), s.time);
      squares += (s.v.col(p) - exact).squaredNorm();
      scale += (exact - of_run.carried).squaredNorm();
    }
    errors.push_back({rung.name, rung.spacing, s.time, error, 100 * std::sqrt(squares / scale)});
  }
  return errors;
}

/// Of each variant against the plain flow.
std::vector<Error> changes(const Results& results, const Record& record) {
  const auto of = [&](const std::string& rung) {
    const Run* run = results.run(rung);
    return run ? error_of(error, end)(record, *run).value_or(not_a_number) : not_a_number;
  };
  std::vector<Error> found;
  for (const Rung& rung : results.method.rungs)
    if (rung.name != plain)
      found.push_back({rung.name, rung.spacing, end, change, 100 * (of(rung.name) / of(plain) - 1)});
  return found;
}

void table_of_changes(const Results& results, Record& record) {
  Table table{
      "changes",
      "What another view of the same flow changes",
      fmt::format("Change of the L2 error of the velocity at t = {:g} s against the plain flow, in per cent of that "
                  "error. Carried along: all moves with (1, 0.5) m/s besides. Turned: by 26.6 degrees against the "
                  "lattice. Disturbed lattice: each particle starts up to a tenth of a spacing off its place.",
                  end),
      {"method"},
      {}};
  std::vector<Cell> row{results.method.name};
  for (const Error& e : changes(results, record)) {
    table.columns.push_back(e.rung + " [%]");
    row.emplace_back(e.value);
  }
  table.rows.push_back(std::move(row));
  record.tables.push_back(std::move(table));
}

std::vector<Rung> rungs() {
  std::vector<Rung> all;
  for (const Variant& v : variants)
    all.push_back({.name = v.name,
                   .spacing = side / particles_across,
                   .cell = 2 * side / particles_across,
                   .acceptance = end,
                   .report = 0,
                   .nightly = end});
  return all;
}

Claim unchanged(const std::string& by, const std::string& words) {
  return between(change, -1, 1, theory(words)).on(by).at(end);
}

/// A method, which `make` makes for a scene, on all variants.
template <class Make>
Method on_all(const Make& make, std::vector<Claim> claims = {}) {
  Method method = make(variants.front().scene());
  method.run = [=](const Rung& rung, const Schedule& when) { return make(variant(rung.name).scene()).run(rung, when); };
  method.rungs = rungs();
  method.claims = std::move(claims);
  method.claims.push_back(unchanged(mirrored, "no direction is preferred to its mirror image"));
  method.claims.push_back(unchanged(numbered_anew, "numbers of particles mean nothing"));
  return method;
}

const std::vector<Claim> galilean = {
    unchanged(carried, "only differences of velocities and places act between particles")};

}  // namespace

Case vnv::the_case() {
  return {
      .title = "Invariance",
      .description =
          "Taylor-Green vortices, Reynolds number 100 and Mach number 0.1, 34 particles across a period, seen in other "
          "ways: mirrored, carried along, turned, from a disturbed lattice, with particles numbered anew. Physics knows "
          "no difference. A method claims what follows from its equations: every method the mirror image and the "
          "numbers; SPH, which knows no grid, also the view of one who is carried along. None is the same in all "
          "directions or from every lattice: there the figures show how much it loses.",
      .times = {end},
      .measurements = {error_seen_at_rest},
      .findings = {changes},
      .methods = {on_all([](const auto& scene) { return mpm_as_printed(scene, whole); }),
                  on_all([](const auto& scene) { return mpm_affine(scene, whole); }),
                  on_all([](const auto& scene) { return mpm_least_squares(scene, whole); }),
                  on_all([](const auto& scene) { return sph_as_printed(scene, whole); }, galilean),
                  on_all([](const auto& scene) { return sph_transport_velocity(scene, whole); }, galilean),
                  on_all([](const auto& scene) { return sph_second_order(scene, whole); }, galilean)},
      .plots = {table_of_changes}};
}
