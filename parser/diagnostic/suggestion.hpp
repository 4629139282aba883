// What an unknown name may be meant to be.
#pragma once

#include <string>
#include <string_view>

namespace lute {

struct Item;
struct Session;

// "did you mean '...'?" for an unknown name, or which file declares it; else "". `expected`: what the message says was expected;
// `block`: the keyword of the block that the name is an item of.
std::string suggestion(Session& session, const Item& found, std::string_view expected = "", std::string_view block = "");

}  // namespace lute
