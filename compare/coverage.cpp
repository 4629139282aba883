#include "compare/coverage.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <map>

namespace lute::compare {
namespace fs = std::filesystem;

namespace {

std::string top_folder(const std::string& scene) { return scene.substr(0, scene.find('/')); }

struct FolderCount {
  int scenes = 0, good = 0;
  std::vector<std::string> open;  // scenes that are not good, with their state
};

void write_features(std::ostream& out, const std::vector<SceneComparison>& features) {
  std::map<std::string, std::vector<const SceneComparison*>> folders;
  for (const SceneComparison& feature : features) {
    folders[fs::path(feature.scene.name).parent_path().string()].push_back(&feature);
  }
  for (const auto& [folder, scenes] : folders) {
    const auto good = std::count_if(scenes.begin(), scenes.end(), [](const auto* s) { return is_good(s->state); });
    out << "\n### " << folder << ": " << good << " of " << scenes.size() << "\n\n";
    out << "| scene | shows | state | within 2/255 | RMSE |\n|---|---|---|---|---|\n";
    for (const SceneComparison* scene : scenes) {
      out << "| " << fs::path(scene->scene.name).stem().string() << " | " << subject_of_scene(scene->scene.path)
          << " | " << name_of(scene->state) << " | ";
      if (scene->difference) {
        out << std::fixed << std::setprecision(2) << 100 * scene->difference->within << " % | " << std::setprecision(5)
            << scene->difference->rmse;
      } else {
        out << "|";
      }
      out << " |\n";
    }
  }
}

void write_examples(std::ostream& out, const StateTable& examples) {
  std::map<std::string, FolderCount> folders;
  FolderCount all;
  for (const auto& [scene, row] : examples) {
    FolderCount& folder = folders[top_folder(scene)];
    for (FolderCount* count : {&folder, &all}) {
      ++count->scenes;
      count->good += is_good(row.state) ? 1 : 0;
    }
    if (!is_good(row.state)) {
      folder.open.push_back(fs::path(scene).stem().string() + " (" + name_of(row.state) + ")");
    }
  }
  out << "\n| folder | scenes | good | open |\n|---|---|---|---|\n";
  for (const auto& [name, folder] : folders) {
    out << "| " << name << " | " << folder.scenes << " | " << folder.good << " | ";
    for (std::size_t i = 0; i < folder.open.size(); ++i) out << (i ? ", " : "") << folder.open[i];
    out << " |\n";
  }
  out << "| **all** | " << all.scenes << " | " << all.good << " | |\n";
}

}  // namespace

std::string subject_of_scene(const fs::path& scene) {
  std::ifstream stream(scene);
  std::string line, text;
  while (std::getline(stream, line) && line.starts_with("// ")) {
    const std::string sentence = line.substr(3);
    const std::size_t stop = sentence.find(". ");
    text += (text.empty() ? "" : " ") + sentence.substr(0, stop);
    if (stop != std::string::npos || sentence.ends_with('.')) break;
  }
  if (text.ends_with('.')) text.pop_back();
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

void write_coverage(std::ostream& out, const std::vector<SceneComparison>& features, const StateTable& examples) {
  out << "# Coverage: what renders as in POV-Ray\n\n"
         "Made by `lute-compare coverage`; do not edit. A feature works when the scene that shows it *matches*\n"
         "([definition](conformance.md)) at 160×120 without antialiasing.\n\n"
         "## Features\n";
  write_features(out, features);
  out << "\n## Example scenes of POV-Ray\n\n"
         "The scenes of the package `povray-examples`, from `tests/conformance/state.csv`. Good: the pictures match, or both\n"
         "programs reject the scene.\n";
  write_examples(out, examples);
}

}  // namespace lute::compare
