// The page of a run: a line of totals, then one card for each scene with both pictures, the heat map and the figures.
#include <filesystem>
#include <string>

#include "compare/content_hash.hpp"
#include "compare/figures.hpp"
#include "compare/html_text.hpp"
#include "compare/report.hpp"

namespace lute::compare {

namespace {

constexpr const char* kStyle = R"css(
:root{--ink:#1d2530;--soft:#5c6878;--line:#dde3ea;--paper:#f5f7f9;--card:#fff;--good:#1b7f4b;--bad:#b3372b;--warn:#a06a00}
@media(prefers-color-scheme:dark){:root{--ink:#e6ebf1;--soft:#97a4b3;--line:#2d3743;--paper:#12171d;--card:#1a2129;--good:#4fc786;--bad:#f0816f;--warn:#e0b050}}
*{box-sizing:border-box}body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,"DejaVu Sans",sans-serif}
main{max-width:1240px;margin:0 auto;padding:28px 20px 60px}h1{font-size:26px;margin:0 0 4px}.where{color:var(--soft);margin:0 0 20px;font-size:13px}
.totals{display:flex;flex-wrap:wrap;gap:10px;margin:0 0 22px;padding:0;list-style:none}
.totals li{background:var(--card);border:1px solid var(--line);border-radius:8px;padding:10px 16px;min-width:108px}
.totals b{display:block;font-size:22px;font-variant-numeric:tabular-nums}.totals span{color:var(--soft);font-size:12.5px}
article{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:14px 16px;margin:0 0 14px;display:grid;grid-template-columns:minmax(220px,1fr) 2.6fr;gap:16px}
@media(max-width:820px){article{grid-template-columns:1fr}}
h2{font-size:15px;margin:0 0 6px;overflow-wrap:anywhere}.state{display:inline-block;font-size:12px;font-weight:600;border:1px solid currentColor;border-radius:99px;padding:1px 10px;margin:0 0 8px}
.good{color:var(--good)}.bad{color:var(--bad)}.warn{color:var(--warn)}
dl{display:grid;grid-template-columns:auto 1fr;gap:1px 12px;margin:0;font-size:13px}dt{color:var(--soft)}dd{margin:0;text-align:right;font-variant-numeric:tabular-nums}
.why{font-size:12.5px;color:var(--soft);overflow-wrap:anywhere;margin:8px 0 0;font-family:ui-monospace,"DejaVu Sans Mono",monospace}
.pictures{display:grid;grid-template-columns:repeat(3,1fr);gap:10px;align-content:start}figure{margin:0}
figure img{width:100%;display:block;border-radius:5px;background:repeating-conic-gradient(#ccc 0 25%,#eee 0 50%) 0/16px 16px;image-rendering:auto}
figcaption{font-size:12px;color:var(--soft);margin-top:3px}.none{border:1px dashed var(--line);border-radius:5px;aspect-ratio:4/3;display:grid;place-items:center;color:var(--soft);font-size:12.5px}
)css";

const char* tone(SceneState state) {
  if (is_good(state)) return "good";
  return state == SceneState::kUnsupported || state == SceneState::kReferenceTimeout ? "warn" : "bad";
}

void write_figure(std::ostream& out, const std::filesystem::path& picture, const char* caption) {
  out << "<figure>";
  if (picture.empty()) {
    out << "<div class=none>no picture</div>";
  } else {
    out << "<img loading=lazy alt=\"" << caption << "\" src=\"data:image/png;base64," << base64(read_file(picture))
        << "\">";
  }
  out << "<figcaption>" << caption << "</figcaption></figure>";
}

void write_term(std::ostream& out, const char* name, const std::string& value) {
  out << "<dt>" << name << "<dd>" << value;
}

void write_figures(std::ostream& out, const SceneComparison& c) {
  out << "<dl>";
  if (c.difference) {
    write_term(out, "within 2/255", formatted("%.3f %%", 100 * c.difference->within));
    write_term(out, "RMSE", formatted("%.5f", c.difference->rmse));
    write_term(out, "largest difference", formatted("%.3f", c.difference->maximum));
    write_term(out, "8×8 blocks, 98th percentile", formatted("%.2f/255", c.difference->block98_255));
  }
  if (c.noise) write_term(out, "reference against itself", "RMSE " + formatted("%.5f", c.noise->rmse));
  write_term(out, "lute, processor / wall",
             formatted("%.2f", c.lute.process.cpu) + " / " + formatted("%.2f s", c.lute.process.wall));
  write_term(out, "POV-Ray, processor / wall",
             formatted("%.2f", c.reference.cpu) + " / " + formatted("%.2f s", c.reference.wall));
  if (const auto ratio = c.cpu_ratio()) write_term(out, "processor time, ratio", formatted("%.3f", *ratio));
  out << "</dl>";
}

void write_card(std::ostream& out, const SceneComparison& c) {
  out << "<article><div><h2>" << html_text(c.scene.name) << "</h2><span class=\"state " << tone(c.state) << "\">"
      << name_of(c.state) << "</span>";
  write_figures(out, c);
  if (!c.reason.empty()) out << "<p class=why>" << html_text(c.reason) << "</p>";
  out << "</div><div class=pictures>";
  write_figure(out, c.lute.picture, "lute");
  write_figure(out, c.reference.picture, "POV-Ray");
  write_figure(out, c.heat_map, "difference, white = 32/255 and more");
  out << "</div></article>\n";
}

void write_total(std::ostream& out, const std::string& value, const std::string& name, const char* tone_name = "") {
  out << "<li><b class=\"" << tone_name << "\">" << value << "</b><span>" << html_text(name) << "</span></li>";
}

}  // namespace

void write_html(std::ostream& out, const std::vector<SceneComparison>& comparisons, const ReportContext& context) {
  const Summary summary = summarize(comparisons);
  out << "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport "
         "content=\"width=device-width,initial-scale=1\"><title>"
      << html_text(context.title) << "</title><style>" << kStyle << "</style><main><h1>" << html_text(context.title)
      << "</h1><p class=where>" << html_text(context.lute_version) << " · " << html_text(context.reference_version)
      << " · switches " << html_text(context.switches) << " · " << html_text(context.machine)
      << "</p><ul class=totals>";
  write_total(out, std::to_string(comparisons.size()), "scenes");
  for (const auto& [state, count] : summary.counts)
    write_total(out, std::to_string(count), name_of(state), tone(state));
  if (summary.cpu_ratio > 0) {
    write_total(out, formatted("%.3f", summary.cpu_ratio),
                "processor time of lute over POV-Ray, geometric mean of matching scenes");
    write_total(out, formatted("%.3f", summary.worst_cpu_ratio), "worst ratio of a matching scene");
  }
  out << "</ul>\n";
  for (const SceneComparison* comparison : worst_first(comparisons)) write_card(out, *comparison);
  out << "</main></html>\n";
}

}  // namespace lute::compare
