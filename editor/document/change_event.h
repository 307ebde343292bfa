// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMetaType>
#include <string>

#include "core/property/property_table.h"

namespace spin {

enum class ChangeKind {
  Reset,    ///< another scene: everything is new
  Added,    ///< a node was added
  Removed,  ///< a node was removed
  Moved,    ///< the order of the nodes changed
  Renamed,
  Enabled,
  Property,  ///< plain value or keys of one property
  Painted,   ///< painted layer of a node
};

/// What changed in the document; listeners update only what it names.
struct ChangeEvent {
  ChangeKind kind = ChangeKind::Reset;
  std::string node;      ///< empty for Reset and Moved
  std::string property;  ///< for Property
  Affects affects = Affects::Both;
};

}  // namespace spin

Q_DECLARE_METATYPE(spin::ChangeEvent)
