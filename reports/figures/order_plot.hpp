#pragma once
/// Errors over spacing on logarithmic axes, and how surely their slopes are known.

#include "reports/compare/orders.hpp"
#include "reports/figures/plot.hpp"

namespace touchstone::reports {

/// Its title, caption and axes.
vnv::Figure order_figure(const OrderComparison& comparison);

/// Each method a line with points; the 95 % interval of its order as a band, its floor dashed, slopes 1 and 2 in grey
/// below the data.
Plot plot_orders(const OrderComparison& comparison);

}  // namespace touchstone::reports
