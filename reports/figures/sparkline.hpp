#pragma once
/// A series as a small picture within a page: a line over nights, its steps marked.

#include "reports/compare/series.hpp"

#include <string>

namespace touchstone::reports {

/// An inline SVG, 100 wide and 30 high in its own unit; nights stand at equal distances, the page says which they are.
/// Values are drawn between their lowest and highest, logarithmically where these are positive and more than a factor
/// of ten apart. A limit is drawn where it lies between them.
std::string sparkline(const Series& series);

}  // namespace touchstone::reports
