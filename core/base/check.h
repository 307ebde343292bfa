// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>
#include <string>

/// Three tiers of failure: Result<T> (core/base/result.h) for the user's or the world's fault, SPIN_CHECK for
/// our bug (always on), SPIN_DCHECK for debug builds only. A failed check prints what it saw and aborts.
namespace spin::detail {

[[noreturn]] void checkFailed(const char* file, int line, const char* condition, const std::string& detail);

template <class A, class B>
std::string showPair(const A& a, const B& b) {
  std::ostringstream out;
  out << a << " against " << b;
  return out.str();
}

}  // namespace spin::detail

#define SPIN_CHECK(condition, message)                                                      \
  do {                                                                                      \
    if (!(condition)) ::spin::detail::checkFailed(__FILE__, __LINE__, #condition, message); \
  } while (false)

#define SPIN_CHECK_COMPARE(a, op, b)                                                                      \
  do {                                                                                                    \
    if (!((a)op(b)))                                                                                      \
      ::spin::detail::checkFailed(__FILE__, __LINE__, #a " " #op " " #b, ::spin::detail::showPair(a, b)); \
  } while (false)

#define SPIN_CHECK_EQ(a, b) SPIN_CHECK_COMPARE(a, ==, b)
#define SPIN_CHECK_LT(a, b) SPIN_CHECK_COMPARE(a, <, b)
#define SPIN_CHECK_LE(a, b) SPIN_CHECK_COMPARE(a, <=, b)

#ifdef NDEBUG
#define SPIN_DCHECK(condition, message) \
  do {                                  \
  } while (false)
#else
#define SPIN_DCHECK(condition, message) SPIN_CHECK(condition, message)
#endif
