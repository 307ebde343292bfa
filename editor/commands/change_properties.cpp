// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/commands/change_properties.h"

#include <algorithm>

#include "editor/commands/command_ids.h"
#include "editor/document/edit_access.h"

namespace spin {

PropertyState stateOf(const SceneNode& node, const PropertyInfo& property) {
  PropertyState state{plainValue(node, property), {}};
  const auto curve = node.curves.find(property.id);
  if (curve != node.curves.end() && !curve->second.empty()) state.curve = curve->second;
  return state;
}

ChangeProperties::ChangeProperties(SceneDocument& document, std::string node, std::vector<Change> changes,
                                   edit::Session session, const QString& text)
    : QUndoCommand(text),
      m_document(document),
      m_node(std::move(node)),
      m_changes(std::move(changes)),
      m_session(session) {}

int ChangeProperties::id() const {
  return m_session != 0 ? kChangePropertiesId : -1;
}

bool ChangeProperties::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const ChangeProperties*>(other);
  if (!next || next->m_session != m_session || next->m_node != m_node) return false;
  if (!std::equal(m_changes.begin(), m_changes.end(), next->m_changes.begin(), next->m_changes.end(),
                  [](const Change& a, const Change& b) { return a.property == b.property; }))
    return false;
  for (std::size_t i = 0; i < m_changes.size(); ++i) m_changes[i].after = next->m_changes[i].after;
  setObsolete(std::all_of(m_changes.begin(), m_changes.end(),
                          [](const Change& change) { return change.before == change.after; }));
  return true;
}

void ChangeProperties::undo() {
  apply(&Change::before);
}

void ChangeProperties::redo() {
  apply(&Change::after);
}

void ChangeProperties::apply(PropertyState Change::*side) {
  SceneNode* node = EditAccess::scene(m_document).find(m_node);
  SPIN_CHECK(node, "undo step of a node that is not there: " + m_node);
  for (const Change& change : m_changes) {
    const PropertyState& state = change.*side;
    setPlainValue(*node, *change.property, state.plain);
    if (state.curve)
      node->curves[change.property->id] = *state.curve;
    else
      node->curves.erase(change.property->id);
  }
  for (const Change& change : m_changes)
    EditAccess::notify(m_document,
                       {ChangeKind::Property, m_node, change.property->id, change.property->affects});
}

}  // namespace spin
