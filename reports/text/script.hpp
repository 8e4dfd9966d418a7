#pragma once
/// The one script of all pages. Without it they say the same: it sorts tables and tells the points of a trend.

#include <string_view>

namespace touchstone::reports {

inline constexpr std::string_view script = R"js("use strict";

// "1.2 × 10−7" and "12 345 of 6" as numbers; a date or a name is none.
function numberOf(text) {
  const plain = text.replace(/\u202f×\u202f10/, "e").replace(/−/g, "-").replace(/(\d)\u202f(?=\d)/g, "$1");
  const found = plain.match(/^(?:≤\s*)?(-?\d*\.?\d+(?:e-?\d+)?)(?![\w-])/);
  return found ? Number(found[1]) : /^-?inf/.test(plain) ? (plain[0] === "-" ? -Infinity : Infinity) : NaN;
}

const textOf = (row, column) => (row.cells[column]?.textContent ?? "").trim();
const isBlank = (text) => text === "" || text === "–" || text === "nan";

// Blank cells stay last, whichever way the others go.
function sortBy(heading) {
  const body = heading.closest("table").tBodies[0], column = heading.cellIndex;
  const rows = [...body.rows].map((row) => ({row, text: textOf(row, column)}));
  const filled = rows.filter((r) => !isBlank(r.text)), blank = rows.filter((r) => isBlank(r.text));
  const isNumeric = filled.every((r) => !Number.isNaN(numberOf(r.text)));
  const falling = heading.ariaSort === "ascending" ? -1 : 1;
  filled.sort((a, b) => falling * (isNumeric ? numberOf(a.text) - numberOf(b.text)
                                             : a.text.localeCompare(b.text, "en", {numeric: true})));
  for (const other of heading.parentNode.cells) other.ariaSort = null;
  heading.ariaSort = falling > 0 ? "ascending" : "descending";
  body.append(...filled.map((r) => r.row), ...blank.map((r) => r.row));
}

for (const heading of document.querySelectorAll("table:not(.matrix *) th")) {
  heading.tabIndex = 0;
  heading.title = "sort";
  heading.addEventListener("click", () => sortBy(heading));
  heading.addEventListener("keydown", (event) => { if (event.key === "Enter") sortBy(heading); });
}

const nights = (document.querySelector("main")?.dataset.nights ?? "").split(",");

// Shows the night under the pointer in place of the last line of the curve, and a rule at it.
function tell(trend, night) {
  const values = trend.dataset.values.split(","), last = trend.lastElementChild;
  const told = Math.max(0, Math.min(values.length - 1, night));
  trend.dataset.told = told;
  trend.dataset.words ??= last.innerHTML;
  last.textContent = `${nights[told]}: ${values[told] || "not run"}`;
  trend.style.setProperty("--told", values.length < 2 ? 0.5 : 0.03 + 0.94 * told / (values.length - 1));
  trend.classList.add("told");
}
function untell(trend) {
  if (trend.dataset.words) trend.lastElementChild.innerHTML = trend.dataset.words;
  delete trend.dataset.words;
  delete trend.dataset.told;
  trend.classList.remove("told");
}
const trendAt = (event) => event.target.closest?.(".trend");
function tellUnder(event) {
  const trend = trendAt(event);
  if (!trend) return;
  const box = trend.querySelector("svg").getBoundingClientRect();
  const share = ((event.clientX - box.left) / box.width - 0.03) / 0.94;
  tell(trend, Math.round(share * (nights.length - 1)));
}
document.addEventListener("pointermove", tellUnder);
document.addEventListener("pointerdown", tellUnder);
document.addEventListener("pointerout", (event) => {
  const trend = trendAt(event);
  if (trend && !trend.contains(event.relatedTarget)) untell(trend);
});
document.addEventListener("focusout", (event) => { if (trendAt(event)) untell(trendAt(event)); });
document.addEventListener("keydown", (event) => {
  const trend = trendAt(event), way = {ArrowLeft: -1, ArrowRight: 1}[event.key];
  if (trend && way) tell(trend, Number(trend.dataset.told ?? nights.length) + way);
});
)js";

}  // namespace touchstone::reports
