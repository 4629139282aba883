#pragma once

namespace lute {

// Between the words of a line.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace lute
