/// vnv scene: all that a solver needs to compute a flow.

#include "vnv/command/commands.hpp"
#include "vnv/command/settings.hpp"
#include "vnv/doors/scene.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/flows/formulas/flow_file.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace touchstone::vnv::command {

int scene(const Build&, const SceneOptions& options) {
  if (options.flow.empty()) {
    for (const std::string& name : known_flows()) fmt::print("{:24} {}\n", name, flow_of(name).judged.title);
    return all_holds;
  }
  const Flow flow = flow_of(options.flow, settings_of(options.set));
  const double spacing = options.spacing.value_or(flow.across / 40);
  if (!options.particles.empty()) files::write_whole(options.particles, doors::particles_as_csv(flow, spacing));
  fmt::print("{}", options.as_json ? doors::scene_as_json(flow, spacing) : doors::scene_in_words(flow, spacing));
  return all_holds;
}

}  // namespace touchstone::vnv::command
