#include "vnv/flows/channels/channel_run_time.hpp"

#include "vnv/record/record.hpp"

namespace touchstone::vnv::channel {
namespace {

WorkPoint elsewhere(std::string series, std::string family, std::string run, double particles, double error,
                    double cpu) {
  return {.series = std::move(series),
          .family = std::move(family),
          .run = std::move(run),
          .elsewhere = true,
          .particles = particles,
          .error = error,
          .cpu = cpu,
          .cpu_lowest = cpu,
          .cpu_highest = cpu};
}

}  // namespace

std::vector<WorkPoint> published_work(const std::string& flow) {
  std::vector<WorkPoint> points;
  for (const char* family : {"MPM", "SPH"}) {
    const DataTable paper = published(flow, family);
    const ValuesWithUnits& geometry = paper.provenance().geometry;
    const double steps = geometry.at("end_time").value / geometry.at("time_step").value;
    for (std::size_t k = 0; k < paper.rows(); ++k) {
      const double per_step = 1e-3 * paper.numbers("T_p [ms]")[k];
      points.push_back(elsewhere(fmt::format("Sun et al., {}", family), family, paper.words("model")[k],
                                 paper.numbers("particles [-]")[k], paper.numbers("L2 [%]")[k], steps * per_step));
      points.back().per_step = per_step;
    }
  }
  return points;
}

std::vector<WorkPoint> peers_in_poiseuille_flow() {
  const DataTable peers = read_table(data_folder() / "peers" / "poiseuille_run_time.csv");
  require_geometry(peers, "gap", H, 1e-9);
  require_geometry(peers, "end_time", 1, 1e-9);
  std::vector<WorkPoint> points;
  for (std::size_t k = 0; k < peers.rows(); ++k)
    points.push_back(elsewhere(peers.words("code")[k], "SPH", "", peers.numbers("particles [-]")[k],
                               peers.numbers("L2 [%]")[k], peers.numbers("CPU [s]")[k]));
  return points;
}

}  // namespace touchstone::vnv::channel
