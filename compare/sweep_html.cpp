// The page of a sweep: for each scene a log–log chart of error over processor time with the Pareto front, a table of
// the points, and the pictures behind them.
#include "compare/content_hash.hpp"
#include "compare/figures.hpp"
#include "compare/html_text.hpp"
#include "compare/sweep_chart.hpp"
#include "compare/sweep_summary.hpp"

namespace lute::compare {

namespace {

constexpr const char* kStyle = R"css(
:root{--ink:#1d2530;--soft:#5c6878;--line:#dde3ea;--paper:#f5f7f9;--card:#fff}
@media(prefers-color-scheme:dark){:root{--ink:#e6ebf1;--soft:#97a4b3;--line:#2d3743;--paper:#12171d;--card:#1a2129}}
*{box-sizing:border-box}body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,"DejaVu Sans",sans-serif}
main{max-width:1100px;margin:0 auto;padding:28px 20px 60px}h1{font-size:26px;margin:0 0 4px}h2{font-size:18px;margin:0 0 8px}p{color:var(--soft);margin:0 0 18px;max-width:75ch}
section{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:16px 18px;margin:0 0 18px}
svg{width:100%;height:auto;display:block}
table{border-collapse:collapse;width:100%;font-size:13px;margin:10px 0}th{text-align:left;color:var(--soft);font-weight:500}td,th{padding:3px 10px 3px 0;border-bottom:1px solid var(--line)}td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(150px,1fr));gap:10px;margin-top:10px}figure{margin:0}figure img{width:100%;border-radius:4px;display:block}figcaption{font-size:11.5px;color:var(--soft);overflow-wrap:anywhere}
)css";

void write_figure(std::ostream& out, const std::filesystem::path& picture, const std::string& caption) {
  if (picture.empty()) return;
  out << "<figure><img loading=lazy alt=\"\" src=\"data:image/png;base64," << base64(read_file(picture))
      << "\"><figcaption>" << html_text(caption) << "</figcaption></figure>";
}

void write_points(std::ostream& out, const Sweep& sweep) {
  out << "<table><tr><th>program<th>switches<th class=n>processor s<th class=n>wall s<th class=n>RMSE<th "
         "class=n>within 2/255<th>front</tr>";
  for (const SweepPoint& p : sweep.points) {
    out << "<tr><td>" << p.program << "<td>" << html_text(p.setting);
    if (p.rendered) {
      out << "<td class=n>" << formatted("%.3f", p.cpu) << "<td class=n>" << formatted("%.3f", p.wall) << "<td class=n>"
          << formatted("%.5f", p.rmse) << "<td class=n>" << formatted("%.2f %%", 100 * p.within) << "<td>"
          << (p.pareto ? "yes" : "");
    } else {
      out << "<td colspan=5>not rendered: " << html_text(p.failure);
    }
    out << "</tr>";
  }
  out << "</table><details><summary>Pictures</summary><div class=pictures>";
  write_figure(out, sweep.converged, "converged, 256 samples a pixel");
  for (const SweepPoint& p : sweep.points) {
    if (!p.rendered) continue;
    write_figure(out, p.picture, p.program + " " + p.setting);
    write_figure(out, p.heat_map, "error of it, white = 32/255");
  }
  out << "</div></details>";
}

void write_equal_errors(std::ostream& out, const Sweep& sweep) {
  const std::vector<EqualError> pairs = at_equal_error(sweep);
  if (pairs.empty()) return;
  out << "<table><tr><th>at the error of POV-Ray with<th class=n>RMSE<th class=n>its processor s<th class=n>+AM3 "
         "s<th class=n>share</tr>";
  for (const EqualError& pair : pairs) {
    out << "<tr><td>" << html_text(pair.setting) << "<td class=n>" << formatted("%.5f", pair.rmse) << "<td class=n>"
        << formatted("%.3f", pair.reference_cpu) << "<td class=n>" << formatted("%.3f", pair.own_cpu) << "<td class=n>"
        << formatted("%.2f", pair.share()) << "</tr>";
  }
  out << "</table>";
}

}  // namespace

void write_html(std::ostream& out, const std::vector<Sweep>& sweeps, const std::string& machine) {
  out << "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport "
         "content=\"width=device-width,initial-scale=1\"><title>Error "
         "against run time</title><style>"
      << kStyle
      << "</style><main><h1>Error against run time</h1><p>Each point is one setting: its error against a converged "
         "picture of the "
      << "scene (256 samples a pixel) and the median of its processor times, one thread. " << html_text(machine)
      << "</p><p>" << html_text(summary(sweeps)) << "</p>";
  for (const Sweep& sweep : sweeps) {
    out << "<section><h2>" << html_text(sweep.scene.name) << "</h2>";
    write_chart(out, sweep);
    write_equal_errors(out, sweep);
    write_points(out, sweep);
    out << "</section>\n";
  }
  out << "</main></html>\n";
}

}  // namespace lute::compare
