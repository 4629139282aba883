// Text and bytes as HTML wants them.
#pragma once

#include <string>
#include <string_view>

namespace lute::compare {

// With the characters that HTML gives a meaning replaced.
std::string html_text(std::string_view text);

// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace lute::compare
