// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

#include "core/property/property_table.h"

namespace spin {

/// A small drawn icon for a type of node.
QIcon nodeIcon(const NodeType& type);

}  // namespace spin
