// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <string>

#include "core/base/result.h"

namespace spin {

enum class Severity { Information, Warning, Error };

/// One line of the issues panel.
struct DocumentIssue {
  Severity severity = Severity::Warning;
  std::string node;      ///< id of the node to jump to; may be empty
  std::string property;  ///< id of the property to jump to; may be empty
  QString text;          ///< what is wrong and what to do
  friend bool operator==(const DocumentIssue&, const DocumentIssue&) = default;
};

/// An error as an issue of a node.
DocumentIssue issueOf(const Error& error, const std::string& node, Severity severity = Severity::Error);

}  // namespace spin
