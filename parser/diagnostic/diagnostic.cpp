#include "parser/diagnostic/diagnostic.hpp"

#include <algorithm>
#include <cstdio>

namespace lute {

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::kWarning: return "warning";
    case Severity::kPossibleError: return "possible error";
    case Severity::kError: return "error";
  }
  return "";
}

SceneError::SceneError(Diagnostic diagnostic) : std::runtime_error(diagnostic.message), diagnostic_(std::move(diagnostic)) {}

void DiagnosticSink::report(Diagnostic diagnostic) {
  if (diagnostic.severity != Severity::kError && all_.size() >= limit_) {
    ++suppressed_;
    return;
  }
  if (listener_) listener_(diagnostic);
  all_.push_back(std::move(diagnostic));
}

namespace {

std::string place(const std::string& file, SourceLocation where) {
  if (where.line == 0) return file;
  return file + ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
}

// The excerpt with tabs kept in the caret line too, so that the caret stands below its character in any terminal. Long lines
// (generated meshes) are cut to a window around the column.
std::string excerpt_with_caret(const Diagnostic& d) {
  constexpr std::size_t kWindow = 110, kBefore = 60;
  const std::size_t column = d.where.column == 0 ? 0 : d.where.column - 1;
  const std::size_t start = column > kWindow - 20 ? column - kBefore : 0;
  if (start >= d.excerpt.size() && start > 0) return "";
  std::string shown = d.excerpt.substr(start, kWindow);
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 32 && c != '\t') c = ' ';
  }
  std::string marks;
  for (std::size_t i = start; i < column; ++i) marks += i < d.excerpt.size() && d.excerpt[i] == '\t' ? '\t' : ' ';
  const std::size_t end = std::max<std::size_t>(d.end_column, d.where.column + 1) - 1;
  marks += '^';
  if (end > column + 1) marks += std::string(std::min(end - column - 1, kWindow), '~');
  return "  " + shown + "\n  " + marks + "\n";
}

void append_json_string(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    switch (c) {
      case '"': out += "\\\""; break;
      case '\\': out += "\\\\"; break;
      case '\n': out += "\\n"; break;
      case '\r': out += "\\r"; break;
      case '\t': out += "\\t"; break;
      default:
        if (static_cast<unsigned char>(c) < 32) {
          char escape[8];
          std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned char>(c));
          out += escape;
        } else {
          out += c;
        }
    }
  }
  out += '"';
}

void append_field(std::string& out, std::string_view key, std::string_view text) {
  append_json_string(out, key);
  out += ':';
  append_json_string(out, text);
}

void append_place(std::string& out, SourceLocation where) {
  out += ",\"line\":" + std::to_string(where.line) + ",\"column\":" + std::to_string(where.column);
}

}  // namespace

std::string to_text(const Diagnostic& d) {
  std::string out = place(d.file, d.where) + ": " + std::string(name_of(d.severity)) + ": " + d.message + "\n";
  if (!d.excerpt.empty()) out += excerpt_with_caret(d);
  for (const DiagnosticNote& note : d.chain) out += "  " + note.text + " " + place(note.file, note.where) + "\n";
  if (!d.hint.empty()) out += "  hint: " + d.hint + "\n";
  return out;
}

std::string to_json(std::span<const Diagnostic> diagnostics) {
  std::string out = "[";
  for (const Diagnostic& d : diagnostics) {
    if (out.size() > 1) out += ",\n ";
    out += '{';
    append_field(out, "severity", name_of(d.severity));
    out += ',';
    append_field(out, "code", d.code);
    out += ',';
    append_field(out, "file", d.file);
    append_place(out, d.where);
    out += ",\"endColumn\":" + std::to_string(d.end_column) + ',';
    append_field(out, "message", d.message);
    out += ',';
    append_field(out, "hint", d.hint);
    out += ",\"chain\":[";
    for (std::size_t i = 0; i < d.chain.size(); ++i) {
      if (i > 0) out += ',';
      out += '{';
      append_field(out, "text", d.chain[i].text);
      out += ',';
      append_field(out, "file", d.chain[i].file);
      append_place(out, d.chain[i].where);
      out += '}';
    }
    out += "]}";
  }
  return out + "]\n";
}

namespace {

// Optimal string alignment distance: insert, delete, replace, swap neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), current(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = a[i - 1] == b[j - 1];
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, last[j - 1] + (equal ? 0u : 1u)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        current[j] = std::min(current[j], before_last[j - 2] + 1);
      }
    }
    before_last = last;
    last = current;
  }
  return last[b.size()];
}

constexpr std::size_t kFewest = 3;  // letters: shorter names are near to everything

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool differ_in_case_only(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, small, small); }

// A slip at the first letter is rare: of a short word with another one too little is left.
std::size_t slips_between(std::string_view name, std::string_view candidate) {
  if (differ_in_case_only(name, candidate)) return 0;
  const bool begins_otherwise = name.size() <= 4 && small(name.front()) != small(candidate.front());
  return edit_distance(name, candidate) + (begins_otherwise ? 1u : 0u);
}

}  // namespace

std::string_view nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
  std::string_view best;
  std::size_t best_distance = name.size() < kFewest ? 0 : name.size() == 3 ? 1 : name.size() <= 7 ? 2 : 3;
  for (const std::string_view candidate : candidates) {
    const std::size_t difference =
        candidate.size() > name.size() ? candidate.size() - name.size() : name.size() - candidate.size();
    if (candidate == name || candidate.empty() || difference > best_distance) continue;
    const std::size_t distance = slips_between(name, candidate);
    if (distance > 0 && candidate.size() < kFewest) continue;
    if (distance < best_distance || (distance == best_distance && best.empty())) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace lute
