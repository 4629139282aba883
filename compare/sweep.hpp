// Error against run time: one scene rendered by both programs with a range of settings, each picture measured against a
// converged picture of the same scene.
//
// The converged picture has 256 samples a pixel: POV-Ray renders the scene without antialiasing at 16 times the width
// and height, and the mean of each 16×16 square is taken in linear light before clamping, as antialiasing does
// (specification chapter 30 §6). It is made once and kept beside the reference cache.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "compare/difference.hpp"
#include "compare/renderer.hpp"
#include "compare/scene_files.hpp"

namespace lute::compare {

struct SweepSettings {
  int width = 160, height = 120;
  std::vector<std::string> variations;  // each a group of switches, for example "+AM2 +A0.1 +R3"
  int runs = 3;                         // of which the median time counts
  double time_limit = 120;              // seconds for one run
  std::string lute_program = "lute", reference_program = "povray";
  std::filesystem::path output;
};

struct SweepPoint {
  std::string program;  // "lute" or "POV-Ray"
  std::string setting;  // the switches
  std::string method;   // "no antialiasing", "method 1" …: as method_of() has it
  bool rendered = false;
  std::string failure;  // why it was not
  double cpu = 0, wall = 0;  // seconds, medians
  double rmse = 0;           // against the converged picture, coded values 0…1
  double within = 0;         // share of pixels within 2/255 of it
  bool pareto = false;       // no other point is both faster and better
  std::filesystem::path picture, heat_map;
};

// What a table has to say about its figures.
struct SweepCircumstances {
  std::string machine, size;  // "160x120"
  int runs = 0;
  std::string lute_version, reference_version;

  std::string text() const;  // one sentence or two
};

struct Sweep {
  SceneFile scene;
  std::vector<SweepPoint> points;
  std::filesystem::path converged;
};

// The converged picture, from the cache folder or made now. Throws std::runtime_error when POV-Ray does not render it.
Picture converged_picture(const SceneFile& scene, const SweepSettings& settings,
                          const std::filesystem::path& cache_folder);

Sweep run_sweep(const SceneFile& scene, const SweepSettings& settings, const std::filesystem::path& cache_folder);

void mark_pareto_front(std::vector<SweepPoint>& points);

void write_csv(std::ostream& out, const std::vector<Sweep>& sweeps);
nlohmann::json to_json(const std::vector<Sweep>& sweeps, const SweepCircumstances& circumstances);
// The figures of what to_json wrote; no pictures. Both throw nlohmann::json::exception where it is something else.
std::vector<Sweep> from_json(const nlohmann::json& report);
SweepCircumstances circumstances_of(const nlohmann::json& report);
void write_html(std::ostream& out, const std::vector<Sweep>& sweeps, const std::string& machine);

}  // namespace lute::compare
