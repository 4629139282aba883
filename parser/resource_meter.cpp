#include "parser/resource_meter.hpp"

#include <algorithm>
#include <string>

#include "parser/machine_memory.hpp"
#include "parser/session.hpp"

namespace lute {

namespace {

constexpr std::uint64_t kTokensBetweenChecks = 1 << 15;
constexpr std::uint64_t kChargeBetweenChecks = 16u << 20;

}  // namespace

ResourceMeter::ResourceMeter(Session& session, const ParseLimits& limits)
    : session_(session),
      limits_(limits),
      memory_limit_(limits.memory_bytes != 0 ? limits.memory_bytes : machine_memory() / 4 * 3),
      next_check_(std::min(kTokensBetweenChecks, limits.tokens)) {}

void ResourceMeter::check_tokens() {
  if (tokens_ >= limits_.tokens) {
    session_.fail("Too many tokens: the limit of " + std::to_string(limits_.tokens) + " is reached.", "limit-tokens");
  }
  next_check_ = std::min(tokens_ + kTokensBetweenChecks, limits_.tokens);
  if (!session_.recovery.within_budget()) session_.fail("Reading behind an error takes too long.", "given-up");
  check_memory(0);
}

void ResourceMeter::charge(std::uint64_t bytes) {
  if (bytes > memory_limit_) fail_memory();
  charged_ += bytes;
  if (charged_ >= kChargeBetweenChecks) check_memory(bytes);
}

void ResourceMeter::reserve(double bytes) {
  require(static_cast<double>(reserved_) + bytes);
  reserved_ += static_cast<std::uint64_t>(bytes);
  charge(static_cast<std::uint64_t>(bytes));
}

void ResourceMeter::check_memory(std::uint64_t wanted) {
  charged_ = 0;
  if (resident_bytes() + reserved_ + wanted > memory_limit_) fail_memory();
}

void ResourceMeter::fail_turns() {
  session_.fail("Too many loop turns: the limit of " + std::to_string(limits_.loop_turns) + " is reached.", "limit-loop-turns");
}

void ResourceMeter::fail_memory() {
  session_.fail("The scene needs more memory than the limit of " + std::to_string(memory_limit_ >> 20) + " MB.", "limit-memory");
}

}  // namespace lute
