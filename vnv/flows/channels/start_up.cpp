#include "vnv/flows/channels/start_up.hpp"

#include "vnv/judge/norms.hpp"
#include "vnv/measures/plots/over_time.hpp"

#include <fmt/format.h>

namespace touchstone::vnv::channel {
namespace {

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
    const DataTable paper = published(flow, results.method.family == Family::mpm ? "MPM" : "SPH");
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

/// Figures 6 or 9, errors and cost over the particle number, the errors over spacing and CPU time; table 3 or 4.
std::vector<Plot> figures(const PaperFlow& flow) {
  const DataTable mpm = published(flow.name, "MPM"), sph = published(flow.name, "SPH");
  const std::string errors_figure = fmt::format("figure {}", flow.figure + 1);
  const Axis number{.label = "particle number", .logarithmic = true};
  const Axis error{.label = "error [%]", .logarithmic = true};
  return {
      along_ladders({"errors", "Error against particle number",
                     "Norms (34) and (35) of row means at t = 1 s. Reproduces " + errors_figure + "(a) of Sun et al.",
                     number, error},
                    {points_per_cell, spacing_ladder}, particle_number(),
                    {{", L2", error_of(l2_rows, 1)}, {", Linf", error_of(linf_rows, 1)}}),
      beside({published_curve("errors", "paper MPM, L2", mpm, "L2 [%]", 1),
              published_curve("errors", "paper MPM, Linf", mpm, "Linf [%]", 1),
              published_curve("errors", "paper SPH, L2", sph, "L2 [%]", 1),
              published_curve("errors", "paper SPH, Linf", sph, "Linf [%]", 1)}),
      along_ladders(
          {"step_time",
           "CPU time per step",
           "One core each; the paper's was an AMD Opteron 6272. Reproduces " + errors_figure + "(b) of Sun et al.",
           number,
           {.label = "T_p [ms]", .scale = 1e3, .logarithmic = true}},
          {points_per_cell, spacing_ladder}, particle_number(), {{"", time_per_step()}}),
      beside({published_curve("step_time", "paper MPM", mpm, "T_p [ms]", 1e-3),
              published_curve("step_time", "paper SPH", sph, "T_p [ms]", 1e-3)}),
      work_precision(l2),
      error_against_spacing(
          "convergence", "Error against spacing",
          "L2 error per particle at t = 1 s. More points in the same cell refine the quadrature, not the grid: the "
          "two ladders of MPM are drawn apart.",
          "error [%]", l2, 1),
      comparison(flow.name, fmt::format("Table {} of Sun et al., with results computed here", flow.table)),
  };
}

std::vector<Value> growth_of(const Level& level, const Run& run, const Truth& exact) {
  const Samples *early = run.at(1), *late = run.at(10);
  if (!early || !late) return {};
  const auto error = [&](const Samples& samples) {
    const Profile profile = by_particles(level)(samples);
    std::vector<double> truth;
    for (const double y : profile.at) truth.push_back(exact(y, samples.time));
    return relative_l2(profile.value, truth, profile.weight);
  };
  return {{level.name, level.spacing, late->time, growth, error(*late) / error(*early)}};
}

std::string where(const PaperFlow& flow, const std::string& model) {
  return fmt::format("Sun et al., table {}, {}", flow.table, model);
}

/// L2 [%] at 1 s.
double error_of_the_papers(const PaperFlow& flow, const std::string& model) {
  return published(flow.name, model.starts_with('M') ? "MPM" : "SPH").only("model", model).numbers("L2 [%]")[0];
}

}  // namespace

DataTable published(const std::string& flow, const std::string& method) {
  const DataTable table = read_table(data_folder() / "papers" / "sun_tables_3_4.csv", {"cell [mm]"});
  require_geometry(table, "gap", H, 1e-9);
  return table.only("flow", flow).only("method", method);
}

Claim at_most_the_papers(const PaperFlow& flow, const std::string& model, int divided_by) {
  return at_most(l2_rows, error_of_the_papers(flow, model) / divided_by,
                 literature(where(flow, model) + (divided_by == 1 ? "" : fmt::format(", over {}", divided_by))))
      .on(model)
      .at(1);
}

Claim near_the_papers(const PaperFlow& flow, const std::string& model) {
  const double error = error_of_the_papers(flow, model);
  return between(l2_rows, error / 1.5, error * 1.5, literature(where(flow, model) + ", within 1.5")).on(model).at(1);
}

std::vector<Level> mpm_levels(double finest_report, double nightly_of_M2) {
  const double cell = 0.025 * mm;
  return {
      {.name = "M1", .spacing = cell, .cell = cell, .acceptance = 1, .report = 1, .nightly = 1},
      {.name = "G10", .spacing = H / 20, .cell = H / 10, .acceptance = 1, .report = 1, .nightly = 1},
      {.name = "G20", .spacing = H / 40, .cell = H / 20, .acceptance = 1, .report = 1, .nightly = 1},
      {.name = "M2", .spacing = cell / 2, .cell = cell, .acceptance = 1, .report = 1, .nightly = nightly_of_M2},
      {.name = "M3", .spacing = cell / 3, .cell = cell, .report = 1, .nightly = 1},
      {.name = "M4", .spacing = cell / 4, .cell = cell, .report = 1, .nightly = 1},
      {.name = "G80", .spacing = H / 160, .cell = H / 80, .report = finest_report, .nightly = 1},
  };
}

std::vector<Level> levels_with_models(char series, const std::vector<Across>& all) {
  std::vector<Level> levels = levels_across(H, all);
  for (Level& level : levels)
    if (level.name == "40 across" || level.name == "80 across")
      level.name = series + std::string(level.name == "40 across" ? "1" : "2");
  return levels;
}

Case start_up_case(const PaperFlow& flow, std::function<double(const Samples&)> follow, std::vector<Method> methods,
                   const std::map<std::string, std::vector<Claim>>& claims) {
  const Flow published = flow_named(flow.name);
  const Truth exact = published.along_x();
  for (Method& method : methods)
    if (const auto of_it = claims.find(method.name); of_it != claims.end())
      method.claims.insert(method.claims.begin(), of_it->second.begin(), of_it->second.end());
  const Axis velocity{"v_x [mm/s]", 1e3};
  Case declared = with_plots(
      {.title = published.judged.title,
       .description = published.judged.description + " Evaluated by Fourier terms at late times and by images at early times.",
       .times = {0.05, 0.1, 0.2, 1, 10},
       .monitor = {.interval = 0.02,
                   .evaluate = [=](const Samples& s) { return std::vector{follow(s)}; },
                   .quantities = {{flow.monitored, "m/s"}}},
       .measurements = {norms_of("v_x, row means", by_rows, exact), norms_of("v_x, per particle", by_particles, exact),
                        [=](const Level& level, const Run& run) { return growth_of(level, run, exact); }},
       .methods = std::move(methods),
       .plots = {profiles(
                     {"profile",
                      "Velocity profiles",
                      fmt::format("Row means at 3200 particles. Reproduces figure {}(b) of Sun et al.", flow.figure),
                      {"y [mm]", 1e3},
                      velocity},
                     by_rows, exact, H, {"M2", "S2"}),
                 over_time("history", flow.monitored + " over time",
                           fmt::format("Reproduces figure {}(a) of Sun et al.", flow.figure), velocity, 0,
                           {"M2", "S1"}),
                 exact_over_time(
                     "history", [=](double t) { return exact(H / 2, t); }, 2)}},
      figures(flow));
  declared.priced_as = flow.name + "_run_time";
  return declared;
}

}  // namespace touchstone::vnv::channel
