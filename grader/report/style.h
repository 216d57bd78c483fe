#pragma once

namespace grade {

/// Colours are Okabe and Ito's, which colour-blind eyes tell apart; no meaning is told by a colour alone.
constexpr const char* page_style = R"css(
:root { --good: #0072b2; --bad: #c44e00; --open: #8a6d00; --idle: #6b7280; --ink: #1c2430; --soft: #5b6675; --line: #dde2e9; --paper: #fff; --back: #f4f6f9; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--back); color: var(--ink); font: 15px/1.5 system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 28px 20px 60px; }
h1 { font-size: 25px; margin: 0; } h2 { font-size: 19px; margin: 38px 0 10px; } h3 { font-size: 17px; margin: 0; font-family: ui-monospace, "DejaVu Sans Mono", monospace; }
h4 { font-size: 15px; margin: 0; display: inline; } p { margin: 6px 0; } a { color: var(--good); }
header { display: flex; gap: 28px; align-items: center; justify-content: space-between; background: var(--paper); border: 1px solid var(--line); border-radius: 10px; padding: 22px 26px; }
.score { text-align: right; white-space: nowrap; } .score b { font-size: 44px; line-height: 1; } .score span { color: var(--soft); font-size: 18px; }
.soft { color: var(--soft); font-size: 13.5px; }
.card { background: var(--paper); border: 1px solid var(--line); border-radius: 10px; padding: 16px 20px; margin: 12px 0; }
.head { display: flex; gap: 12px; align-items: baseline; flex-wrap: wrap; } .head .points { margin-left: auto; font-variant-numeric: tabular-nums; }
.badge { font-size: 12.5px; font-weight: 600; border-radius: 999px; padding: 1px 10px; border: 1px solid currentColor; white-space: nowrap; }
.passed { color: var(--good); } .failed, .did_not_build, .crashed, .timed_out, .not_finite { color: var(--bad); }
.inconclusive { color: var(--open); } .not_started { color: var(--idle); }
.hint { border-left: 4px solid var(--bad); padding: 4px 12px; margin: 10px 0; background: #fdf4ee; white-space: pre-line; }
.hint.not_started { border-color: var(--idle); background: #f3f4f6; color: inherit; } .hint.inconclusive { border-color: var(--open); background: #fbf7e6; color: inherit; }
.hint.failed, .hint.crashed, .hint.timed_out, .hint.not_finite { color: inherit; }
pre { background: #f6f7f9; border: 1px solid var(--line); border-radius: 6px; padding: 10px 12px; overflow-x: auto; font: 12.5px/1.45 ui-monospace, "DejaVu Sans Mono", monospace; margin: 8px 0; }
table { border-collapse: collapse; width: 100%; } td, th { text-align: left; padding: 5px 10px 5px 0; border-top: 1px solid var(--line); vertical-align: middle; font-variant-numeric: tabular-nums; }
th { font-size: 12.5px; color: var(--soft); font-weight: 600; border-top: 0; } td.number, th.number { text-align: right; white-space: nowrap; }
.overview td:first-child { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: 13.5px; white-space: nowrap; } .overview a { text-decoration: none; }
.overview .part td { background: #eef2f7; font-weight: 600; font-family: inherit; font-size: 14px; padding-left: 8px; }
.meter { height: 8px; border-radius: 4px; background: #e3e8ef; overflow: hidden; margin-top: 8px; } .meter i { display: block; height: 100%; background: var(--good); }
details.check { border-top: 1px solid var(--line); margin-top: 12px; padding-top: 10px; } summary { cursor: pointer; } summary .badge { margin-left: 8px; }
.pictures { display: flex; flex-wrap: wrap; gap: 14px; margin: 12px 0; } figure { margin: 0; } figcaption { font-size: 13px; color: var(--soft); margin-top: 4px; max-width: 300px; }
.pictures img { width: 300px; max-width: 100%; image-rendering: pixelated; border: 1px solid var(--line); border-radius: 4px; display: block; background: #000; }
.own img { image-rendering: auto; }
.scale { display: inline-block; width: 90px; height: 9px; vertical-align: middle; border: 1px solid var(--line); background: linear-gradient(90deg, #005ab5, #fff, #dc5f00); }
svg.bar { display: block; } .axis { stroke: #c9d0da; } .band { fill: #cfe3f1; } .truth { stroke: #1c2430; stroke-width: 1.5; }
.interval { stroke-width: 3; } .interval.good { stroke: var(--good); } .interval.bad { stroke: var(--bad); } .interval.open { stroke: var(--open); }
.dot.good { fill: var(--good); } .dot.bad { fill: var(--bad); } .dot.open { fill: var(--open); }
@media (max-width: 640px) { header { flex-direction: column; align-items: flex-start; } .score { text-align: left; } }
@media print { body { background: #fff; } .card { break-inside: avoid; } }
)css";

}  // namespace grade
