// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/result.h"

namespace spin {

std::string Error::text() const {
  std::string line = what;
  if (!where.empty()) line += " (" + where + ")";
  if (!why.empty()) line += ": " + why;
  if (!advice.empty()) line += ". " + advice;
  if (!more.empty()) line += "\n" + more;
  return line;
}

int exitCode(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::Failed:
      return 1;
    case ErrorKind::Usage:
      return 2;
    case ErrorKind::BadInput:
      return 3;
    case ErrorKind::OutOfResources:
      return 4;
    case ErrorKind::Cancelled:
      return 5;
  }
  return 1;
}

Error badInput(std::string what, std::string where, std::string why, std::string advice) {
  return Error{ErrorKind::BadInput, std::move(what), std::move(where), std::move(why), std::move(advice)};
}

}  // namespace spin
