#include "parser/value/array.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace lute {

ArrayElements::ArrayElements(const ArrayElements& other)
    : count_(other.count_),
      components_(other.components_),
      numbers_(other.numbers_),
      is_packed_(other.is_packed_),
      values_(other.values_),
      others_(other.others_) {
  for (const auto& [index, lent] : other.lent_) set(index, other.value(index));
}

Slot ArrayElements::find_lent(std::size_t index) const {
  const auto lent = std::ranges::find(lent_, index, &Lent::value_type::first);
  return lent == lent_.end() ? nullptr : lent->second.lock();
}

const Value* ArrayElements::find_value(std::size_t index) const {
  const Value* found = nullptr;
  if (!lent_.empty()) found = find_lent(index).get();  // whoever holds it goes on holding it
  if (found == nullptr) {
    if (!values_.empty()) {
      found = &values_[index];
    } else if (!others_.empty()) {
      const auto other = others_.find(index);
      if (other != others_.end()) found = &other->second;
    }
  }
  return found == nullptr || found->empty() ? nullptr : found;
}

Value ArrayElements::value(std::size_t index) const {
  if (Number number; get_number(index, number)) return number;
  const Value* const value = find_value(index);
  return value != nullptr ? *value : Value();
}

bool ArrayElements::has_value(std::size_t index) const { return is_packed(index) || find_value(index) != nullptr; }

bool ArrayElements::find_number(std::size_t index, Number& result) const {
  const Value* const value = find_value(index);
  const Number* const number = value != nullptr ? value->get_if<Number>() : nullptr;
  if (number == nullptr) return false;
  result = *number;
  return true;
}

bool ArrayElements::find_float(std::size_t index, double& result) const {
  Number number;
  if (!get_number(index, number) || !number.is_float()) return false;
  result = number.c[0];
  return true;
}

Value ArrayElements::first_value() const {
  for (std::size_t i = 0; i < count_; ++i) {
    if (has_value(i)) return value(i);
  }
  return {};
}

std::uint64_t ArrayElements::bytes_to_set(const Value& value) const {
  if (has_storage() || value.empty()) return 0;
  const Number* const number = value.get_if<Number>();
  return number != nullptr ? count_ * static_cast<std::size_t>(number->count) * sizeof(double) + count_ / 8 : count_ * sizeof(Value);
}

std::uint64_t ArrayElements::bytes() const {
  return numbers_.size() * sizeof(double) + is_packed_.size() / 8 + (values_.size() + others_.size()) * sizeof(Value);
}

void ArrayElements::choose_storage(const Value& first) {
  if (const Number* const number = first.get_if<Number>()) {
    components_ = number->count;
    numbers_.resize(count_ * static_cast<std::size_t>(components_));
    is_packed_.resize(count_);
  } else {
    values_.resize(count_);
  }
}

void ArrayElements::store_number(std::size_t index, const Number& number) {
  is_packed_[index] = true;
  double* const to = numbers_.data() + index * static_cast<std::size_t>(components_);
  for (int i = 0; i < components_; ++i) to[i] = number.c[static_cast<std::size_t>(i)];
}

void ArrayElements::set(std::size_t index, Value value) {
  if (!lent_.empty()) {
    if (const Slot lent = find_lent(index)) {
      *lent = std::move(value);
      return;
    }
  }
  if (!has_storage()) {
    if (value.empty()) return;
    choose_storage(value);
  }
  if (!values_.empty()) {
    values_[index] = std::move(value);
    return;
  }
  if (!others_.empty()) others_.erase(index);
  const Number* const number = value.get_if<Number>();
  if (number != nullptr && number->count == components_) {
    store_number(index, *number);
  } else {
    is_packed_[index] = false;
    if (!value.empty()) others_[index] = std::move(value);
  }
}

// An element outside its array, which keeps the array alive and gets the value back.
struct ArrayElements::Loan {
  Value value;
  ArrayPtr array;
  std::size_t index;

  Loan(const ArrayPtr& from, std::size_t element) : value(from->elements.value(element)), array(from), index(element) {}
  ~Loan() {
    Lent& lent = array->elements.lent_;
    assert(array->elements.has_storage());  // a loan that ends allocates nothing
    lent.erase(std::ranges::find(lent, index, &Lent::value_type::first));
    array->elements.set(index, std::move(value));
  }
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
};

Slot ArrayElements::reference(const ArrayPtr& array, std::size_t index) {
  ArrayElements& elements = array->elements;
  if (!elements.has_storage()) return std::make_shared<Value>();
  if (Slot lent = elements.find_lent(index)) return lent;
  if (!elements.values_.empty()) return Slot(array, &elements.values_[index]);
  const auto loan = std::make_shared<Loan>(array, index);
  Slot slot(loan, &loan->value);
  elements.lent_.emplace_back(index, slot);
  return slot;
}

Array::Array(std::vector<int> dimensions)
    : sizes(std::move(dimensions)),
      elements(std::accumulate(sizes.begin(), sizes.end(), std::size_t{1},
                               [](std::size_t count, int size) { return count * static_cast<std::size_t>(size); })) {}

int array_nesting(const Value& value) {
  const ArrayPtr* const array = value.get_if<ArrayPtr>();
  if (array == nullptr) return 0;
  int inside = 0;
  (*array)->elements.for_each_value([&](const Value& element) { inside = std::max(inside, array_nesting(element)); });
  return inside + 1;
}

}  // namespace lute
