#include "engine/memory/shared.hpp"

#include <gtest/gtest.h>

#include <string>

#include "engine/memory/shared_transform.hpp"
#include "engine/memory/shared_variant.hpp"

namespace lute {
namespace {

TEST(Shared, CopiesShareUntilOneIsEdited) {
  Shared<std::string> a(std::string("one"));
  Shared<std::string> b = a;
  EXPECT_TRUE(a.shares(b));
  b.edit() += " more";
  EXPECT_FALSE(a.shares(b));
  EXPECT_EQ(*a, "one");
  EXPECT_EQ(*b, "one more");
}

TEST(Shared, ASoleOwnerEditsInPlace) {
  Shared<std::string> a(std::string("one"));
  const std::string* before = &*a;
  a.edit() += " more";
  EXPECT_EQ(&*a, before);
}

TEST(Shared, TheDefaultValueTakesNoMemory) {
  Shared<std::string> a, b;
  EXPECT_TRUE(a.is_default());
  EXPECT_EQ(*a, "");
  EXPECT_EQ(&*a, &*b);
  a.edit() = "one";
  EXPECT_FALSE(a.is_default());
  EXPECT_EQ(*b, "");
}

TEST(SharedTransform, TheIdentityTakesNoMemory) {
  EXPECT_TRUE(SharedTransform(Transform()).identity());
  const SharedTransform moved = Transform::translate({1, 2, 3});
  EXPECT_FALSE(moved.identity());
  EXPECT_TRUE(moved.then({}).shares(moved));
  EXPECT_TRUE(SharedTransform().then(moved).shares(moved));
  EXPECT_EQ(moved.then(Transform::scale(dvec3(2)))->translation, dvec3(2, 4, 6));
}

using Number = SharedVariant<int, double, std::string>;

TEST(SharedVariant, HoldsOneOfItsAlternatives) {
  const Number number(std::string("two"));
  EXPECT_EQ(number.get_if<int>(), nullptr);
  ASSERT_NE(number.get_if<std::string>(), nullptr);
  EXPECT_EQ(*number.get_if<std::string>(), "two");
  EXPECT_EQ(number.visit([](const auto& value) { return sizeof(value); }), sizeof(std::string));
}

TEST(SharedVariant, CopiesShareUntilOneIsEdited) {
  Number a(1);
  Number b = a;
  EXPECT_EQ(a.get_if<int>(), b.get_if<int>());
  b.edit([](auto& value) {
    if constexpr (requires { value += 1; }) value += 1;
  });
  EXPECT_EQ(*a.get_if<int>(), 1);
  EXPECT_EQ(*b.get_if<int>(), 2);
  a = b;
  EXPECT_EQ(a.get_if<int>(), b.get_if<int>());
}

}  // namespace
}  // namespace lute
