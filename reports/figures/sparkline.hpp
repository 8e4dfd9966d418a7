#pragma once
/// A series as a small picture within a page: a line over nights, its steps marked.

#include "reports/compare/series.hpp"

#include <string>
#include <vector>

namespace touchstone::reports {

/// A path of an SVG, "M3 27L26.5 3", and the class by which the style sheet knows it.
struct SparklinePath {
  std::string kind, d;
};

/// Paths in a picture 100 wide and 30 high in its own unit; nights stand at equal distances, the page says which they
/// are. Values are drawn between their lowest and highest, logarithmically where these are positive and more than a
/// factor of ten apart. A limit is drawn where it lies between them.
std::vector<SparklinePath> sparkline(const Series& series);

}  // namespace touchstone::reports
