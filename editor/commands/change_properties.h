// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QUndoCommand>
#include <optional>
#include <string>
#include <vector>

#include "core/property/scene_node.h"
#include "editor/commands/edits.h"

namespace spin {

/// Everything a node holds for one property.
struct PropertyState {
  Value plain;
  std::optional<AnimationCurve> curve;
  friend bool operator==(const PropertyState&, const PropertyState&) = default;
};
PropertyState stateOf(const SceneNode& node, const PropertyInfo& property);

/// Changes properties of one node: plain values, keys or both. Serves every kind of edit of a property.
class ChangeProperties : public QUndoCommand {
 public:
  struct Change {
    const PropertyInfo* property;
    PropertyState before;
    PropertyState after;
  };

  ChangeProperties(SceneDocument& document, std::string node, std::vector<Change> changes,
                   edit::Session session, const QString& text);

  int id() const override;
  bool mergeWith(const QUndoCommand* other) override;
  void undo() override;
  void redo() override;

 private:
  void apply(PropertyState Change::*side);

  SceneDocument& m_document;
  std::string m_node;
  std::vector<Change> m_changes;
  edit::Session m_session;
};

}  // namespace spin
