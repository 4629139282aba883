#include "parser/value/symbol_table.hpp"

#include <algorithm>

namespace lute {

SymbolTable::Entry* SymbolTable::find_in(NameId name, std::uint32_t table) {
  if (name >= entries_.size()) return nullptr;
  for (Entry& entry : entries_[name])
    if (entry.table == table) return &entry;
  return nullptr;
}

SymbolTable::Entry& SymbolTable::add(NameId name, std::uint32_t table, Slot slot) {
  ++generation_;
  if (name >= entries_.size()) entries_.resize(std::max<std::size_t>(name + 1, entries_.size() * 2));
  std::vector<Entry>& stack = entries_[name];
  // A global that is created while inner entries exist goes below them.
  auto at = stack.end();
  while (at != stack.begin() && (at - 1)->table > table) --at;
  tables_[table].push_back(name);
  return *stack.insert(at, Entry{.slot = std::move(slot), .table = table, .deprecation = nullptr});
}

void SymbolTable::remove(NameId name) {
  ++generation_;
  if (find(name) != nullptr) entries_[name].pop_back();
}

void SymbolTable::pop_table() {
  const std::uint32_t table = newest();
  if (!tables_.back().empty()) ++generation_;
  for (const NameId name : tables_.back()) {
    if (!entries_[name].empty() && entries_[name].back().table == table) entries_[name].pop_back();
  }
  tables_.pop_back();
}

void SymbolTable::for_each_name(const std::function<void(NameId)>& f) const {
  for (std::size_t name = 0; name < entries_.size(); ++name) {
    if (!entries_[name].empty()) f(static_cast<NameId>(name));
  }
}

}  // namespace lute
