#include "app/html_style.hpp"

namespace shellback::app {

const char* page_style() {
  return R"css(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --panel: #f6f7f9; --ink: #1c2430; --muted: #5b6675; --rule: #dfe3e8;
  --accent: #2f7f86; --more: #c2492f; --less: #2f7f86; --total: #46536a; --alarm: #fdecea;
  --s0: #2b6cb0; --s1: #d08a00; --s2: #2f7f86; --s3: #c2392b; --s4: #7a4fa3;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14181f; --panel: #1b212a; --ink: #e4e8ee; --muted: #9aa6b5; --rule: #2e3743;
    --accent: #5fb8bf; --more: #e8775c; --less: #5fb8bf; --total: #93a3bd; --alarm: #3a1d1a;
    --s0: #6aa9ee; --s1: #e6b04a; --s2: #5fb8bf; --s3: #f0705f; --s4: #b794dd;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
}
main { max-width: 1240px; margin: 0 auto; padding: 36px 28px 64px; }
.kicker { color: var(--accent); font-size: 12px; letter-spacing: .12em; text-transform: uppercase;
  margin: 0; font-weight: 600; }
h1 { font-size: 28px; line-height: 1.2; margin: 4px 0 4px; font-weight: 650; }
.scene { color: var(--muted); margin: 0 0 20px; }
h2 { font-size: 17px; margin: 40px 0 12px; padding-bottom: 6px;
  border-bottom: 1px solid var(--rule);
  font-weight: 650; }
.verdict { background: var(--panel); border-left: 4px solid var(--accent); padding: 14px 18px;
  margin: 0 0 8px; font-size: 16px; }
.verdict p { margin: 0 0 4px; } .verdict p:last-child { margin: 0; }
.failed { background: var(--alarm); border: 2px solid var(--more); padding: 14px 18px;
  margin: 0 0 14px; }
.failed strong { color: var(--more); font-size: 18px; display: block; }
.failed dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 14px; margin: 8px 0; }
.failed dt { color: var(--muted); } .failed dd { margin: 0; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 14px;
  min-width: 100%; }
th, td { padding: 5px 12px; text-align: right; border-bottom: 1px solid var(--rule);
  white-space: nowrap; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
thead th { color: var(--muted); font-weight: 600; border-bottom: 2px solid var(--rule); }
td.unit, th.unit { text-align: left; color: var(--muted); }
td.text { text-align: left; white-space: normal; color: var(--muted); }
td.measured { font-weight: 600; } td.bad, th.bad { color: var(--more); font-weight: 600; }
td small { color: var(--muted); display: block; font-size: 12px; line-height: 1.2; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 520px), 1fr));
  gap: 20px 28px; }
.figures.single { grid-template-columns: minmax(0, 860px); }
figure { margin: 0; } figure svg { width: 100%; height: auto; display: block; }
figcaption { color: var(--muted); font-size: 13px; margin-top: 2px; }
ul { margin: 0; padding-left: 20px; } li { margin: 3px 0; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 460px), 1fr));
  gap: 0 40px; }
details { margin-top: 12px; } summary { cursor: pointer; color: var(--muted); }
pre { background: var(--panel); padding: 14px 16px; overflow-x: auto; font-size: 12.5px;
  line-height: 1.45; }
footer { margin-top: 48px; color: var(--muted); font-size: 13px; }
@media print { main { max-width: none; padding: 0; } .scroll { overflow: visible; } }
)css";
}

}  // namespace shellback::app
