// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/document_issue.h"

namespace spin {

DocumentIssue issueOf(const Error& error, const std::string& node, Severity severity) {
  return {severity, node, {}, QString::fromStdString(error.text())};
}

}  // namespace spin
