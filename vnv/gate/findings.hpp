#pragma once
/// What a gate found, for a terminal, for a review, for a page and for other programs.

#include "vnv/gate/difference.hpp"

#include <string>
#include <vector>

namespace touchstone::gate {

/// All that a gate found.
struct Findings {
  std::string before, after;  // as they were asked for
  std::string suite;
  std::vector<Difference> differences;  // what is the same too
  std::vector<std::string> skipped;     // cases whose programs are the same
};

/// The worst change of all; same if nothing was judged.
Change conclusion_of(const Findings& findings);

/// Lines for a terminal: a table of cases and methods, what changed, worst first, and the conclusion last.
std::string text_of(const Findings& findings);

/// The conclusion, a table of cases and methods, and what changed, worst first, to be pasted in a review.
std::string markdown_of(const Findings& findings);

/// The conclusion and what is worse or inconclusive, worst first, as verdicts of a page; their limit is how it was
/// before.
std::vector<vnv::Verdict> verdicts_of(const Findings& findings);

/// The table of cases and methods, for a page.
vnv::Table page_table_of(const Findings& findings);

/// Everything. As in a record, what is not a number is the text "nan".
std::string json_of(const Findings& findings);

}  // namespace touchstone::gate
