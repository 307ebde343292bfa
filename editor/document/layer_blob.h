// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include "core/property/scene_node.h"

namespace spin {

/// A painted layer as bytes for the recovery files: compressed, only tiles that are not blank. Needs no
/// foreign library, so that it works while everything else fails.
QByteArray packLayer(const PaintedLayer& layer);
/// Every number is checked before memory is taken.
Result<PaintedLayer> unpackLayer(const QByteArray& bytes, const std::string& nameForMessages);

}  // namespace spin
