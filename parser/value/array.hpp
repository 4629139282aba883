// Arrays of the scene language. Elements that are numbers of one type lie packed as doubles (a float takes 8 bytes, a vector 24); all
// other elements are Values. Row-major, 1 to 5 dimensions. Source: specification chapter 10 §9.2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "parser/value/value.hpp"

namespace lute {

// How the elements lie in memory is decided by the first that gets a value, and takes memory from then on.
class ArrayElements {
 public:
  explicit ArrayElements(std::size_t count = 0) : count_(count) {}
  ArrayElements(const ArrayElements& other);  // what is lent in `other` is not lent in the copy
  ArrayElements& operator=(const ArrayElements&) = delete;

  std::size_t size() const { return count_; }

  // Elements without a value are empty.
  Value value(std::size_t index) const;
  bool has_value(std::size_t index) const;
  // False unless the element is a number, or a float.
  bool get_number(std::size_t index, Number& result) const {
    if (!is_packed(index)) return find_number(index, result);
    result = Number();
    result.count = components_;
    const double* const from = numbers_.data() + index * static_cast<std::size_t>(components_);
    for (int i = 0; i < components_; ++i) result.c[static_cast<std::size_t>(i)] = from[i];
    return true;
  }
  bool get_float(std::size_t index, double& result) const {
    if (components_ != 1 || !lent_.empty() || !is_packed_[index]) return find_float(index, result);
    result = numbers_[index];
    return true;
  }
  // The element unless it is empty or lies packed, else null.
  const Value* find_value(std::size_t index) const;
  // The first that is not empty, or an empty one.
  Value first_value() const;

  void set(std::size_t index, Value value);  // an empty one takes the element's value away
  // Bytes that set() will allocate for all elements together because this is the first value.
  std::uint64_t bytes_to_set(const Value& value) const;
  std::uint64_t bytes() const;

  // For each element that does not lie packed.
  template <class F>
  void for_each_value(F&& f) {
    for (Value& value : values_) f(value);
    for (auto& [index, value] : others_) f(value);
  }

  // The element as a variable. A packed one lives outside the array until the last reference to it goes. Where no element has had a
  // value yet, it is an empty one of its own.
  static Slot reference(const ArrayPtr& array, std::size_t index);

 private:
  struct Loan;

  // The loans of the elements that are outside: few, as there are few macro parameters.
  using Lent = std::vector<std::pair<std::size_t, std::weak_ptr<Value>>>;

  bool has_storage() const { return components_ != 0 || !values_.empty(); }
  bool is_packed(std::size_t index) const {
    return components_ != 0 && is_packed_[index] && (lent_.empty() || find_lent(index) == nullptr);
  }
  Slot find_lent(std::size_t index) const;
  bool find_number(std::size_t index, Number& result) const;
  bool find_float(std::size_t index, double& result) const;
  void choose_storage(const Value& first);
  void store_number(std::size_t index, const Number& number);

  std::size_t count_;
  int components_ = 0;           // of packed numbers; 0: none
  std::vector<double> numbers_;  // `components_` for each element
  std::vector<bool> is_packed_;  // the element's value is in numbers_, unless it is lent
  std::vector<Value> values_;    // in their stead. Never resized: references point to them.
  // Among packed numbers: values of other types, which macro parameters that refer to elements may leave there.
  std::unordered_map<std::size_t, Value> others_;
  Lent lent_;
};

struct Array {
  std::vector<int> sizes;  // 1 to 5 of them
  ArrayElements elements;
  std::size_t type = 0;         // of what was assigned last: see type_code()
  std::string_view type_name;   // the same for messages

  explicit Array(std::vector<int> dimensions);
};

// Arrays in arrays: 0 for a value that is none, 1 for an array of other things. Of values that nothing refers into.
int array_nesting(const Value& value);

}  // namespace lute
