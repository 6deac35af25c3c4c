#include "report/viewer/html_page.h"

namespace clearcut::report {

const char* const kHtmlStyle = R"css(
* { box-sizing: border-box; }
body { margin: 0; padding: 20px 26px; font: 14px/1.45 sans-serif; color: var(--ink); background: #fff; }
header { display: flex; align-items: center; justify-content: space-between; gap: 20px; }
h1 { margin: 0; font-size: 26px; overflow-wrap: anywhere; }
h2 { margin: 18px 0 6px; font-size: 15px; }
#verdict { padding: 7px 18px; border-radius: 18px; color: #fff; font-weight: bold; white-space: nowrap; }
#tiles { display: flex; flex-wrap: wrap; gap: 10px; margin: 12px 0 16px; }
#tiles div { flex: 1 1 110px; padding: 8px 12px; border-radius: 6px; background: #f3f5f7; color: var(--faint); font-size: 12px; }
#tiles b { display: block; font-size: 19px; color: var(--ink); white-space: nowrap; }
#tiles .bad, #tiles .bad b { background: #fdebec; color: var(--bad); }
main { display: grid; grid-template-columns: minmax(0, 1fr) 380px; gap: 22px; }
@media (max-width: 900px) { main { grid-template-columns: 1fr; } }
#stage { position: relative; border: 1px solid var(--rule); border-radius: 6px; overflow: hidden; background: #fff; }
#stage canvas { position: absolute; inset: 0; width: 100%; height: 100%; }
#controls { display: flex; align-items: center; gap: 12px; margin-top: 10px; }
#controls input[type=range] { flex: 1; }
#timeline { display: flex; height: 14px; margin-top: 10px; border-radius: 4px; overflow: hidden; border: 1px solid var(--rule); position: relative; cursor: pointer; }
#timeline i { position: absolute; top: 0; bottom: 0; width: 2px; background: var(--bad); }
button, select { font: inherit; padding: 4px 12px; border: 1px solid var(--rule); border-radius: 6px; background: #f3f5f7; color: var(--ink); cursor: pointer; }
#play { width: 84px; font-weight: bold; }
table { width: 100%; border-collapse: collapse; }
td, th { padding: 3px 6px; text-align: right; font-variant-numeric: tabular-nums; }
th { font-weight: normal; color: var(--faint); font-size: 12px; }
td:first-child, th:first-child { text-align: left; overflow-wrap: anywhere; }
#features tr[data-t], #faults li { cursor: pointer; }
#features tr[data-t]:hover, #faults li:hover { background: #f3f5f7; }
#features tr.now { background: #e8f1fa; }
.swatch { display: inline-block; width: 14px; height: 14px; margin-right: 8px; border: 1px solid var(--rule); vertical-align: -2px; }
.dot { display: inline-block; width: 10px; height: 10px; border-radius: 5px; background: var(--rule); }
.good { background: var(--good); } .bad-dot { background: var(--bad); }
#now td { text-align: left; } #now td:first-child { color: var(--faint); width: 80px; }
#code { margin: 8px 0 0; padding: 8px 10px; border-radius: 6px; background: #1c2733; color: #aebac6; font: 12px/1.5 monospace; overflow: hidden; white-space: pre; }
#code b { color: #fff; font-weight: normal; background: #35506b; display: block; }
#faults { margin: 0; padding: 0; list-style: none; max-height: 260px; overflow: auto; }
#faults li { padding: 5px 8px; border-left: 3px solid var(--bad); margin-bottom: 4px; }
label { white-space: nowrap; }
)css";

const char* const kHtmlBody = R"html(
<header><h1 id="title"></h1><div id="verdict"></div></header>
<div id="tiles"></div>
<main>
 <section>
  <div id="stage"><canvas id="relief"></canvas><canvas id="overlay"></canvas></div>
  <div id="timeline" title="features in order of work; red: faults"></div>
  <div id="controls">
   <button id="play" type="button">Play</button>
   <input id="scrub" type="range" min="0" max="100000" value="0" aria-label="time"/>
   <span id="clock"></span>
   <select id="speed" aria-label="speed"></select>
   <label><input id="path" type="checkbox" checked="checked"/> path</label>
  </div>
 </section>
 <aside>
  <h2>Now</h2>
  <table id="now"></table>
  <div id="code" hidden="hidden"></div>
  <h2>Features</h2>
  <table id="features"></table>
  <div id="faults-box" hidden="hidden"><h2>Faults</h2><ul id="faults"></ul></div>
 </aside>
</main>
<noscript>This page needs JavaScript to play the machining.</noscript>
)html";

}  // namespace clearcut::report
