// The dump of a scene for golden files: short enough to be read.
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <string>

namespace lute::test {

using Members = std::map<std::string, nlohmann::json>;

// The members of the objects in a dump, the first of each name. Those of shapes, cameras and settings belong to their own kind only.
inline void collect_members(const nlohmann::json& json, Members& members) {
  for (const auto& [key, value] : json.items()) {
    if (key == "geometry") continue;
    if (json.is_object()) members.emplace(key, value);
    if (value.is_structured() && key != "camera" && key != "global_settings") collect_members(value, members);
  }
}

// Without the members that have the value that they have in `plain`.
inline nlohmann::json without(const nlohmann::json& json, const Members& plain) {
  if (!json.is_structured()) return json;
  nlohmann::json result = json.is_object() ? nlohmann::json::object() : nlohmann::json::array();
  for (const auto& [key, value] : json.items()) {
    if (json.is_array()) {
      result.push_back(without(value, plain));
    } else if (const auto known = plain.find(key); known == plain.end() || known->second != value) {
      result[key] = without(value, plain);
    }
  }
  return result;
}

// An array or object stays on one line if the line holds it, an array of numbers always: a vector is a line and not five.
inline std::string compact_text(const nlohmann::json& json, std::size_t indent = 0) {
  constexpr std::size_t kWidth = 130;
  const std::string line = json.dump();
  const bool numbers = json.is_array() && std::ranges::all_of(json, [](const auto& value) { return value.is_number(); });
  if (!json.is_structured() || numbers || indent + line.size() <= kWidth) return line;
  const std::string step = "\n" + std::string(indent + 2, ' ');
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (!text.empty()) text += ",";
    text += step;
    if (json.is_object()) text += nlohmann::json(key).dump() + ": ";
    text += compact_text(value, indent + 2);
  }
  const std::string end = "\n" + std::string(indent, ' ');
  return json.is_object() ? "{" + text + end + "}" : "[" + text + end + "]";
}

}  // namespace lute::test
