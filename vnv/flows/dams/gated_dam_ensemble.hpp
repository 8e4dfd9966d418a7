#pragma once
/// The impact of the dam break at H = 0.3 m as an ensemble: the starts of `dam_break_validation` beside the repeats of
/// the experiment. The flow is chaotic after the impact, so that no single run can be compared.

#include "vnv/flows/dams/gated_dam.hpp"

namespace touchstone::vnv::gated_dam {

/// The pressure at P2, median and percentiles 2.5 % and 97.5 % of the ensemble and of 100 repeats, clocks aligned by
/// arrival within what they are in doubt by; and a table of the distances between both distributions: of that pressure
/// at some times, and of the first peaks at P1 to P3.
Plot ensemble_beside_repeats();

/// How much of the time the ensemble is where the experiment is.
std::vector<Value> ensemble_values(const Results& results, const Record& record);
inline const Quantity median_inside_band{
    "fraction of T_H 2.4 to 6 with the ensemble's median within the 95 % band of P2", "", Kind::value, Better::larger},
    levels_inside_ensemble{"fraction of T_H 5 to 7 with the measured levels H2 to H4 within the ensemble's range", "",
                           Kind::value, Better::larger},
    unlike_repeats{"pressures and peaks by which the ensemble is unlike the repeats, p < 0.01", "", Kind::count,
                   Better::smaller};

}  // namespace touchstone::vnv::gated_dam
