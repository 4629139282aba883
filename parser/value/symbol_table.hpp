// Names and what they hold, in scopes: table 0 is global, each include file and macro call adds one. Lookup goes from the
// newest to the oldest (dynamic scope) and costs the same at any depth: each name has its own stack of entries.
// Source: specification chapter 10 §3.1.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "parser/value/value.hpp"

namespace lute {

// `#declare deprecated`: what every use of the name says.
struct Deprecation {
  std::string message;
  bool once = false;
  bool told = false;
  // The last use that was told of: it may be looked up again before it is taken.
  const Token* use = nullptr;
  std::uint64_t use_event = 0;
};

class SymbolTable {
 public:
  struct Entry {
    Slot slot;
    std::uint32_t table = 0;
    std::uint8_t depth = 0;  // of a macro parameter that stands for an array element: arrays in each other around it
    std::shared_ptr<Deprecation> deprecation;
  };

  // The reference has 100 tables, of which one holds the reserved words.
  static constexpr std::size_t kMostTables = 99;

  SymbolTable() : tables_(1) {}

  Entry* find(NameId name) {
    if (name >= entries_.size() || entries_[name].empty()) return nullptr;
    return &entries_[name].back();
  }
  Value* find_value(NameId name) {
    Entry* entry = find(name);
    return entry == nullptr ? nullptr : entry->slot.get();
  }
  Entry* find_in_newest(NameId name) {
    Entry* entry = find(name);
    return entry != nullptr && entry->table == newest() ? entry : nullptr;
  }

  Entry* find_in(NameId name, std::uint32_t table);

  // A new entry in a table that has none of that name. Returns it.
  Entry& add(NameId name, std::uint32_t table, Slot slot);
  void remove(NameId name);  // the innermost entry

  std::uint32_t newest() const { return static_cast<std::uint32_t>(tables_.size() - 1); }
  // Changes whenever a name is added or removed: until then the place of a name's value stays the same.
  std::uint64_t generation() const { return generation_; }
  std::size_t table_count() const { return tables_.size(); }
  void push_table() { tables_.emplace_back(); }
  void pop_table();

  void for_each_name(const std::function<void(NameId)>& f) const;

 private:
  std::vector<std::vector<Entry>> entries_;  // by name, in the order of their tables
  std::uint64_t generation_ = 1;
  std::vector<std::vector<NameId>> tables_;  // names entered in each table (may hold names that were removed since)
};

}  // namespace lute
