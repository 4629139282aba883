// What stands at the beginning of the blocks of objects, for messages about it: "sphere { <center>, radius ... }".
#pragma once

#include <string_view>

namespace lute {

// "" for a keyword whose block has no such beginning.
std::string_view statement_form(std::string_view keyword);

}  // namespace lute
