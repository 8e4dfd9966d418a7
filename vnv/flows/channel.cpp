#include "vnv/flows/channel.hpp"

#include "vnv/record/record.hpp"

namespace touchstone::vnv::channel {
namespace {

const std::vector<std::string> headings = {"flow",         "method", "model",    "particles [-]", "cell [mm]",
                                           "spacing [mm]", "L2 [%]", "Linf [%]", "T_p [ms]",      "memory [MB]"};

Curve published_curve(const std::string& figure, const std::string& label, const DataTable& rows, const std::string& y,
                      double scale) {
  Curve curve{figure, label, Role::published, rows.numbers("particles [-]"), rows.numbers(y), true};
  for (double& value : curve.y) value *= scale;
  return curve;
}

/// Paper, ours and their ratio for each model that both have.
Plot comparison(const std::string& flow, const std::string& title) {
  return [=](const Results& results, Record& record) {
    Table table{
        "comparison",
        title,
        "Errors of row means at t = 1 s, CPU time per step and memory: published, computed here, and their ratio. The "
        "paper's machine was one core of an AMD Opteron 6272; memory is that of the whole process.",
        {"method", "model", "L2 paper [%]", "L2 ours [%]", "ratio", "Linf paper [%]", "Linf ours [%]", "ratio",
         "T_p paper [ms]", "T_p ours [ms]", "ratio", "memory paper [MB]", "memory ours [MB]", "ratio"},
        {}};
    const DataTable paper = published(flow, results.method.name.rfind("mpm", 0) == 0 ? "MPM" : "SPH");
    for (std::size_t k = 0; k < paper.rows(); ++k) {
      const std::string& model = paper.words("model")[k];
      const Run* run = results.run(model);
      if (!run || !error_of(l2_rows, 1)(record, *run)) continue;
      std::vector<Cell> row = {results.method.name, model};
      const auto compare = [&](const std::string& heading, std::optional<double> ours) {
        const double printed = paper.numbers(heading)[k], value = ours.value_or(not_a_number);
        row.insert(row.end(), {printed, value, value / printed});
      };
      compare("L2 [%]", error_of(l2_rows, 1)(record, *run));
      compare("Linf [%]", error_of(linf_rows, 1)(record, *run));
      compare("T_p [ms]", 1e3 * run->summary.cost.per_step());
      compare("memory [MB]", 1e-6 * run->summary.cost.peak_memory);
      table.rows.push_back(std::move(row));
    }
    record.tables.push_back(std::move(table));
  };
}

}  // namespace

DataTable published(const std::string& flow, const std::string& method) {
  const DataTable table = read_table(data_folder() / "papers" / "sun_tables_3_4.csv", headings, {"cell [mm]"});
  require_geometry(table, "gap", H, 1e-9);
  return table.only("flow", flow).only("method", method);
}

std::vector<Plot> figures(const std::string& flow, const std::string& errors_figure, const std::string& table) {
  const DataTable mpm = published(flow, "MPM"), sph = published(flow, "SPH");
  const Axis number{.label = "particle number", .logarithmic = true};
  const Axis error{.label = "error [%]", .logarithmic = true};
  return {
      along_ladders(
          {"errors", "Error against particle number",
           "Norms (34) and (35) of row means at t = 1 s. Reproduces figure " + errors_figure + "(a) of Sun et al.",
           number, error},
          {points_per_cell, spacing_ladder}, particle_number(),
          {{", L2", error_of(l2_rows, 1)}, {", Linf", error_of(linf_rows, 1)}}),
      beside({published_curve("errors", "paper MPM, L2", mpm, "L2 [%]", 1),
              published_curve("errors", "paper MPM, Linf", mpm, "Linf [%]", 1),
              published_curve("errors", "paper SPH, L2", sph, "L2 [%]", 1),
              published_curve("errors", "paper SPH, Linf", sph, "Linf [%]", 1)}),
      along_ladders({"step_time",
                     "CPU time per step",
                     "One core each; the paper's was an AMD Opteron 6272. Reproduces figure " + errors_figure +
                         "(b) of Sun et al.",
                     number,
                     {.label = "T_p [ms]", .scale = 1e3, .logarithmic = true}},
                    {points_per_cell, spacing_ladder}, particle_number(), {{"", time_per_step()}}),
      beside({published_curve("step_time", "paper MPM", mpm, "T_p [ms]", 1e-3),
              published_curve("step_time", "paper SPH", sph, "T_p [ms]", 1e-3)}),
      along_ladders({"cost",
                     "Work-precision diagram",
                     "L2 error of row means at t = 1 s against CPU time; lower left is better.",
                     {.label = "CPU time [s]", .logarithmic = true},
                     error},
                    {}, cpu_time_until(1), {{"", error_of(l2_rows, 1)}}),
      along_ladders(
          {"convergence",
           "Error against spacing",
           "L2 error per particle at t = 1 s. More points in the same cell refine the quadrature, not the grid: the "
           "two ladders of MPM are drawn apart.",
           {.label = "particle spacing [mm]", .scale = 1e3, .logarithmic = true},
           error},
          {}, spacing(), {{"", error_of(l2, 1)}}),
      comparison(flow, "Table " + table + " of Sun et al., with results computed here"),
  };
}

}  // namespace touchstone::vnv::channel
