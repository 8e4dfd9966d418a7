#pragma once
/// The one style sheet of all pages: a printed supplement, readable on a phone.

#include <string_view>

namespace touchstone::reports {

inline constexpr std::string_view style = R"css(:root {
  --ink: #1b1b1b; --quiet: #5b5b5b; --rule: #1b1b1b; --hair: #d9d9d9; --link: #0b5394;
  --holds: #1a6b3c; --holds-pale: #eaf4ee; --fails: #b3261e; --fails-pale: #fbebea; --open: #7a5c00; --open-pale: #fbf4dc;
  --stalled: #8a4100; --stalled-pale: #fdeedd; --untold: #4d4d4d; --untold-pale: #f0f0f0;
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; color: var(--ink); background: #fff;
  font: 17px/1.55 Charter, "Bitstream Charter", "Iowan Old Style", Palatino, Georgia, "DejaVu Serif", serif; }
main { max-width: 68rem; margin: 0 auto; padding: 2.5rem 1.25rem 5rem; overflow-wrap: break-word; }
h1, h2, p, ul, dl { max-width: 42rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: .2rem 0 .8rem; font-weight: 600; }
h2 { font-size: 1.25rem; margin: 3rem 0 1rem; font-weight: 600; }
a { color: var(--link); text-decoration-thickness: 1px; text-underline-offset: 2px; }
.path, .files { color: var(--quiet); font-size: .85rem; }
.files a { margin-left: .5em; white-space: nowrap; }
.sum { font-size: 1.1rem; border-left: 4px solid; padding: .35rem .9rem; }
.sum.holds { border-color: var(--holds); background: var(--holds-pale); }
.sum.fails { border-color: var(--fails); background: var(--fails-pale); }
.sum.known { border-color: var(--stalled); background: var(--stalled-pale); }
.sum.inconclusive { border-color: var(--open); background: var(--open-pale); }
ul.fails, ul.known, ul.inconclusive { padding-left: 1.2rem; font-size: .95rem; }
ul.fails li { color: var(--fails); }
ul.known li, td.known { color: var(--stalled); }
ul.inconclusive li { color: var(--open); }
figure { margin: 0 0 2.5rem; max-width: 48rem; break-inside: avoid; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption, .caption { font-size: .92rem; line-height: 1.45; }
figcaption { margin-top: .6rem; max-width: 42rem; }
body { counter-reset: figure table; }
figcaption::before { counter-increment: figure; content: "Figure " counter(figure) ". "; font-weight: 600; }
.table { margin: 0 0 2.5rem; }
.caption { margin: 0 0 .5rem; }
.caption::before { counter-increment: table; content: "Table " counter(table) ". "; font-weight: 600; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; border-top: 1.5px solid var(--rule); border-bottom: 1.5px solid var(--rule);
  font-size: .82rem; line-height: 1.35; font-variant-numeric: tabular-nums lining-nums; }
th, td { padding: .34rem .6rem; text-align: left; vertical-align: top; }
td { white-space: nowrap; }
th { border-bottom: 1px solid var(--rule); font-weight: 600; vertical-align: bottom; }
tbody tr + tr td { border-top: 1px solid var(--hair); }
th:first-child, td:first-child { padding-left: .3rem; }
.number { text-align: right; }
td.words { white-space: normal; min-width: 9rem; }
td.words.fails { min-width: 24rem; }
.methods { line-height: 1.7; }
.methods span { white-space: nowrap; margin-right: .9em; }
.methods .holds { color: var(--holds); }
.methods .fails { color: var(--fails); font-weight: 600; }
.methods .inconclusive { color: var(--open); font-style: italic; }
td.holds { color: var(--holds); }
td.fails { color: var(--fails); font-weight: 600; }
td.inconclusive { color: var(--open); font-style: italic; }
td.converging { color: var(--holds); }
td.stalled { color: var(--stalled); }
td.diverging { color: var(--fails); font-weight: 600; }
td.holds a, td.fails a, td.inconclusive a, .matrix td a { color: inherit; }
.matrix, .kills { width: calc(100vw - 2.5rem); margin-left: calc(50% - 50vw + 1.25rem); }
.matrix .table { width: fit-content; max-width: 100%; margin-inline: auto; }
.matrix td { white-space: normal; }
.matrix th + th, .matrix td + td { min-width: 9rem; }
.matrix th:first-child, .matrix td:first-child { position: sticky; left: 0; background: #fff; padding-right: 1rem; }
.matrix .converging, .legend .converging { background: var(--holds-pale); color: var(--holds); }
.matrix .stalled, .legend .stalled { background: var(--stalled-pale); color: var(--stalled); }
.matrix .diverging, .legend .diverging { background: var(--fails-pale); color: var(--fails); }
.matrix .inconclusive, .legend .inconclusive { background: var(--untold-pale); color: var(--untold); font-style: normal; }
.matrix .none, .notes { color: var(--quiet); }
.matrix tbody tr td.best { border-top: 1px solid var(--rule); }
.notes { font-size: .85rem; margin: -1.8rem 0 2.5rem; }
.tests span { display: block; overflow-wrap: anywhere; min-width: 14rem; }
.tests .fails { color: var(--fails); }
.tests .holds { color: var(--holds); }
.kills .table { width: fit-content; max-width: 100%; margin-inline: auto; }
.kills th span { writing-mode: vertical-rl; transform: rotate(180deg); white-space: nowrap; }
.kills th, .kills td { padding: .2rem .4rem; }
.kills td + td { text-align: right; border-left: 1px solid var(--hair); }
.kills th:first-child, .kills td:first-child { position: sticky; left: 0; z-index: 1; background: #fff; }
.kills td:first-child { white-space: normal; min-width: 18rem; }
.kills .noticed { background: var(--holds-pale); color: var(--holds); }
.kills .hardly { background: var(--open-pale); color: var(--open); }
.kills .none { color: var(--quiet); }
.legend { list-style: none; padding: 0; max-width: none; display: grid; gap: .5rem; font-size: .88rem; line-height: 1.4;
  grid-template-columns: repeat(auto-fit, minmax(13rem, 1fr)); margin: 1.5rem 0 2rem; }
.legend li { padding: .4rem .7rem; }
.legend b { display: block; }
th[tabindex] { cursor: pointer; }
th[aria-sort="ascending"]::after { content: "\00a0▲"; font-size: .7em; }
th[aria-sort="descending"]::after { content: "\00a0▼"; font-size: .7em; }
.trends h2 { margin: 2.6rem 0 0; }
.trends h3 { font-size: .95rem; font-weight: 600; margin: 1.1rem 0 .35rem; }
.multiples { display: grid; gap: 0 1.5rem; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); }
.trend { display: grid; grid-row: span 3; grid-template-rows: subgrid; row-gap: 0; min-width: 0; margin-bottom: 1rem;
  font-size: .8rem; line-height: 1.35; touch-action: pan-y; break-inside: avoid; }
.trend p { margin: 0; align-self: end; }
.trend p:last-child { align-self: start; }
.trend p:last-child { font-variant-numeric: tabular-nums lining-nums; min-height: 1.35em; }
.trend p:last-child span { color: var(--quiet); margin-right: .4em; white-space: nowrap; }
.trend p:last-child .step { color: var(--stalled); }
.trend b.fails { color: var(--fails); }
.trend svg { display: block; width: 100%; height: 3.4rem; margin: .15rem 0; background: linear-gradient(var(--ink), var(--ink))
  calc(var(--told, -1) * 100%) 0 / 1px 100% no-repeat; border-bottom: 1px solid var(--hair); overflow: visible; }
.trend:not(.told) svg { background: none; }
.trend path { fill: none; vector-effect: non-scaling-stroke; }
.trend .line { stroke: #0072B2; stroke-width: 1.2; }
.trend .dots { stroke: #0072B2; stroke-width: 4; stroke-linecap: round; }
.trend .dots.fails, .trend .nan { stroke: var(--fails); }
.trend path.step { stroke: var(--stalled); stroke-width: 1; }
.trend .limit { stroke: var(--quiet); stroke-width: 1; stroke-dasharray: 4 3; }
.nan { color: var(--fails); font-weight: 600; }
.bar { display: inline-block; width: 3.5rem; height: .55rem; margin-right: .5rem; background: #ececec; }
.bar i { display: block; height: 100%; background: var(--holds); }
.bar.over i { background: var(--fails); }
sub, sup { line-height: 0; }
small { color: var(--quiet); font-weight: 400; }
code { font: .92em ui-monospace, Menlo, Consolas, "DejaVu Sans Mono", monospace; }
dt { font-weight: 600; }
dd { margin: 0 0 1rem 1.2rem; }
dd p { margin: .3rem 0; }
@media (max-width: 40rem) {
  body { font-size: 16px; }
  main { padding: 1.25rem 1rem 3rem; }
  h1 { font-size: 1.5rem; }
  figure img { min-width: 36rem; }
  .kills td:first-child { min-width: 9rem; }
}
@media print {
  .matrix, .kills { width: auto; margin-left: 0; }
  .kills table { table-layout: fixed; width: 100%; font-size: 5pt; }
  .kills th:first-child { width: 30%; }
  .kills th, .kills td { padding: .1rem; }
  .kills td + td { font-size: 0; }
  .multiples { grid-template-columns: repeat(4, 1fr); gap: 0 .9rem; }
  .trend { font-size: 7pt; }
  body { font-size: 10pt; }
  main { max-width: none; padding: 0; }
  .scroll { overflow: visible; }
  table { font-size: 7.5pt; }
  th, td { white-space: normal; padding: .2rem .35rem; }
  td.words { min-width: 0; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace touchstone::reports
