// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "core/base/check.h"

namespace spin {

/// Kinds of failure that are not our bug; each maps to one exit code of the command line.
enum class ErrorKind {
  Failed,          ///< the run failed or an error bar was missed (exit code 1)
  Usage,           ///< the call itself makes no sense (2)
  BadInput,        ///< a file or value from outside is unusable (3)
  OutOfResources,  ///< memory, disk or time is not enough (4)
  Cancelled,       ///< the user stopped it (5)
};

/// What went wrong, where, why, and what the user can do about it. Plain sentences, no trailing full stop.
struct Error {
  ErrorKind kind = ErrorKind::Failed;
  std::string what;       ///< "The terrain could not be read"
  std::string where;      ///< file, node id or property; may be empty
  std::string why;        ///< "the file ends after 12 of 516 rows"
  std::string advice;     ///< "Export the raster again"; may be empty
  std::string more = {};  ///< further problems of the same input, a line each; mostly empty

  /// One line: "what (where): why. advice."; what more there is follows in lines of its own.
  std::string text() const;
};

/// Exit code of the command line for a kind of error.
int exitCode(ErrorKind kind);

/// A value or an Error. Taking the value of a failed result is a bug and stops the program.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return m_state.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return requireValue(), std::get<0>(m_state); }
  const T& value() const& { return requireValue(), std::get<0>(m_state); }
  T&& value() && { return requireValue(), std::get<0>(std::move(m_state)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const {
    SPIN_CHECK(!ok(), "error() of a result that holds a value");
    return std::get<1>(m_state);
  }

 private:
  void requireValue() const {
    if (!ok()) detail::checkFailed(__FILE__, __LINE__, "value() of a failed result", error().text());
  }
  std::variant<T, Error> m_state;
};

/// Success or an Error.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(Error error) : m_error(std::move(error)), m_ok(false) {}

  bool ok() const { return m_ok; }
  explicit operator bool() const { return m_ok; }
  const Error& error() const {
    SPIN_CHECK(!m_ok, "error() of a successful status");
    return m_error;
  }

 private:
  Error m_error;
  bool m_ok = true;
};

/// Shorthand for the commonest failure: something from outside is unusable.
Error badInput(std::string what, std::string where, std::string why, std::string advice = {});

}  // namespace spin
