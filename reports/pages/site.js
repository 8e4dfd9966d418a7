// The one script of all pages. Without it they say the same: it sorts and filters tables and shows the points of a trend.
"use strict";

// "1.2 × 10−7" and "12 345 of 6" as numbers; a date or a name is none.
function numberOf(text) {
  const plain = text.replace(/\u202f×\u202f10/, "e").replace(/−/g, "-").replace(/(\d)\u202f(?=\d)/g, "$1");
  const found = plain.match(/^(?:≤\s*)?(-?\d*\.?\d+(?:e[+-]?\d+)?)(?![\w-])/);
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

for (const heading of document.querySelectorAll("table:not(.matrix *, .flows *) th")) {
  heading.tabIndex = 0;
  heading.title = "sort";
  heading.addEventListener("click", () => sortBy(heading));
  heading.addEventListener("keydown", (event) => { if (event.key === "Enter") sortBy(heading); });
}

// A field above many tables, which keeps the rows that hold, or whose caption holds, every word typed into it.
for (const box of document.querySelectorAll(".filtered")) {
  const field = document.createElement("input"), sections = [...box.querySelectorAll("section")];
  Object.assign(field, {type: "search", placeholder: "filter: poiseuille sph order", ariaLabel: "filter"});
  field.addEventListener("input", () => {
    const words = field.value.toLowerCase().split(/\s+/);
    for (const section of sections) {
      const rows = [...section.querySelector("tbody").rows], title = section.querySelector(".caption").textContent;
      for (const row of rows) {
        const text = (title + row.textContent).toLowerCase();
        row.hidden = !words.every((word) => text.includes(word));
      }
      section.hidden = rows.every((row) => row.hidden);
    }
  });
  box.prepend(field);
}

const nights = (document.querySelector("[data-nights]")?.dataset.nights ?? "").split(",");

// Shows the night under the pointer in place of the last line of the curve, and a rule at it.
function show(trend, night) {
  const values = trend.dataset.values.split(","), last = trend.lastElementChild;
  const shown = Math.max(0, Math.min(values.length - 1, night));
  trend.dataset.shown = shown;
  trend.dataset.words ??= last.innerHTML;
  last.textContent = `${nights[shown]}: ${values[shown] || "not run"}`;
  trend.style.setProperty("--shown", values.length < 2 ? 0.5 : 0.03 + 0.94 * shown / (values.length - 1));
  trend.classList.add("shown");
}
function restore(trend) {
  if (trend.dataset.words) trend.lastElementChild.innerHTML = trend.dataset.words;
  delete trend.dataset.words;
  delete trend.dataset.shown;
  trend.classList.remove("shown");
}
const trendAt = (event) => event.target.closest?.(".trend");
function showUnder(event) {
  const trend = trendAt(event);
  if (!trend) return;
  const box = trend.querySelector("svg").getBoundingClientRect();
  const fraction = ((event.clientX - box.left) / box.width - 0.03) / 0.94;
  show(trend, Math.round(fraction * (nights.length - 1)));
}
document.addEventListener("pointermove", showUnder);
document.addEventListener("pointerdown", showUnder);
document.addEventListener("pointerout", (event) => {
  const trend = trendAt(event);
  if (trend && !trend.contains(event.relatedTarget)) restore(trend);
});
document.addEventListener("focusout", (event) => { if (trendAt(event)) restore(trendAt(event)); });
document.addEventListener("keydown", (event) => {
  const trend = trendAt(event), way = {ArrowLeft: -1, ArrowRight: 1}[event.key];
  if (trend && way) show(trend, Number(trend.dataset.shown ?? nights.length) + way);
});
