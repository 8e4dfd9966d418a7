#pragma once
/// Figures that draw one number of each run against another: errors over particle number, time per step, cost.
/// A figure is declared by the record of every method; the report draws it once, with the curves of all.

#include "vnv/case.hpp"
#include "vnv/record/record.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::vnv {

/// A number of a run, in SI or, for an error, in its own unit; none where the run has not got it.
using Pick = std::function<std::optional<double>(const Record&, const Run&)>;

Pick error_of(Quantity quantity, double time);
Pick particle_number();
Pick spacing();
Pick time_per_step();

/// What is drawn upwards, and what it is called in the key after the method's name.
struct Ordinate {
  std::string suffix;  // ", L2", or empty
  Pick pick;
};

/// One curve for each ladder and ordinate, through the runs that finished. No ladders named: all of the method.
Plot along_ladders(Figure frame, std::vector<std::string> ladders, Pick x, std::vector<Ordinate> ordinates);

/// An error at a time [s] over the particle spacing, a curve for each ladder; `label` is that of the error.
Plot error_against_spacing(std::string id, std::string title, std::string caption, std::string label,
                           const Quantity& error, double time);
/// What an error costs: the report draws all methods of the flow in one diagram, whichever of them declares it.
Plot work_precision(const Quantity& error);
/// Both, of a velocity.
std::vector<Plot> errors_of_velocity(std::string id, const std::string& label, const Quantity& error, double time);

/// The same curves in every record: published values, an experiment, guides to the eye.
Plot beside(std::vector<Curve> curves);

}  // namespace touchstone::vnv
