/// Our own MPM and SPH of the manufactured solution, as classes that the header for solvers of others makes a program
/// of: `our_methods SPACING TIMES PARTICLES PARAMETERS mpm_affine`, or sph_second_order.

#include "vnv/doors/client/touchstone/solver.hpp"
#include "vnv/flows/manufactured.hpp"
#include "vnv/methods/methods.hpp"

#include <string>

using namespace touchstone;

namespace {

class Ours {
 public:
  Ours(const vnv::Method& method, const client::Scene& scene)
      : simulation_(method.solver(level(scene), method.time_step(level(scene)))) {}
  void step() { simulation_.step(); }
  double time() const { return simulation_.time(); }
  client::Samples samples() const {
    const Samples now = simulation_.samples();
    const auto plain = [](const auto& values) { return std::vector<double>(values.begin(), values.end()); };
    return {.x = plain(now.x.row(0)),
            .y = plain(now.x.row(1)),
            .v_x = plain(now.v.row(0)),
            .v_y = plain(now.v.row(1)),
            .p = plain(now.pressure),
            .rho = plain(now.density),
            .mass = plain(now.mass)};
  }

 private:
  static vnv::Level level(const client::Scene& scene) { return {.spacing = scene.spacing, .cell = 2 * scene.spacing}; }
  vnv::Simulation simulation_;
};

struct Mpm : Ours {
  explicit Mpm(const client::Scene& scene)
      : Ours(vnv::mpm_affine(vnv::manufactured::scene(), vnv::square::output_interval), scene) {}
};
struct Sph : Ours {
  explicit Sph(const client::Scene& scene)
      : Ours(vnv::sph_second_order(vnv::manufactured::scene(), vnv::square::output_interval), scene) {}
};

}  // namespace

int main(int count, char** words) {
  return std::string(words[count - 1]) == "mpm_affine" ? client::run<Mpm>(count - 1, words)
                                                       : client::run<Sph>(count - 1, words);
}
