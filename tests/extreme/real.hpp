// The arithmetic of the oracles: 113 bits, so that what they say is right to the last digit of a double.
#pragma once

namespace lute::extreme {

__extension__ typedef __float128 Real;

// Newton's iteration from the double result: each step doubles the digits.
inline Real square_root(Real value) {
  if (value <= 0) return 0;
  Real root = static_cast<Real>(__builtin_sqrt(static_cast<double>(value)));
  for (int i = 0; i < 3; ++i) root = (root + value / root) / 2;
  return root;
}

inline Real magnitude(Real value) { return value < 0 ? -value : value; }

// The largest whole number that is not above; for |value| < 2^62.
inline Real whole(Real value) {
  const Real cut = static_cast<Real>(static_cast<long long>(value));
  return cut > value ? cut - 1 : cut;
}

}  // namespace lute::extreme
