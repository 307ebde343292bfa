// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>
#include <cmath>

#include "editor/commands/change_properties.h"
#include "editor/commands/edits.h"

namespace spin::edit {
namespace {

using Change = ChangeProperties::Change;

constexpr double kLongestFilm = 1e7;  ///< s

QString label(const PropertyInfo& property) {
  return QCoreApplication::translate("Properties", property.label);
}

Error noNode(const std::string& node) {
  return Error{ErrorKind::Failed, "The node cannot be changed", node, "it is not in the scene", {}};
}

Status checkTime(double filmTime) {
  if (std::isfinite(filmTime) && std::abs(filmTime) <= kLongestFilm) return {};
  return Error{ErrorKind::Usage, "The key cannot be set", {}, "its time is out of range", {}};
}

/// Changes that change nothing push no undo step.
void push(SceneDocument& document, const std::string& node, std::vector<Change> changes, Session session,
          const QString& text) {
  bool any = false;
  for (const Change& change : changes) any |= change.before != change.after;
  if (any)
    document.undoStack()->push(new ChangeProperties(document, node, std::move(changes), session, text));
}

struct Target {
  const SceneNode* node;
  const PropertyInfo* property;
};

Result<Target> find(SceneDocument& document, const std::string& node, const std::string& property) {
  const SceneNode* found = document.node(node);
  if (!found) return noNode(node);
  const PropertyInfo* info = found->type->find(property);
  if (!info) return unknownProperty(*found->type, property, node);
  return Target{found, info};
}

/// The state with a key at the time.
Result<PropertyState> withKey(const Target& target, double filmTime, const Value& value,
                              std::optional<Interpolation> interpolation) {
  if (!target.property->animatable)
    return Error{ErrorKind::Usage,
                 "The key cannot be set",
                 target.property->id,
                 "this property cannot be animated",
                 {}};
  if (Status status = checkTime(filmTime); !status) return status.error();
  PropertyState state = stateOf(*target.node, *target.property);
  AnimationCurve curve = state.curve.value_or(AnimationCurve());
  Interpolation kept = Interpolation::Linear;
  for (const Key& key : curve.keys())
    if (key.time <= filmTime + 1e-6) kept = key.interpolation;
  curve.setKey({filmTime, value, interpolation.value_or(kept)});
  state.curve = std::move(curve);
  return state;
}

QString changeText(const std::vector<Change>& changes, const SceneNode& node) {
  if (changes.size() == 1)
    return QCoreApplication::translate("Edits", "Change %1").arg(label(*changes.front().property));
  return QCoreApplication::translate("Edits", "Change %1").arg(QString::fromStdString(node.name));
}

/// Plain values, or keys at a time where a time is given and the property is animated.
Status setAll(SceneDocument& document, const std::string& id, const PropertyValues& values,
              std::optional<double> filmTime, Session session) {
  std::vector<Change> changes;
  for (const auto& [propertyId, value] : values) {
    const Result<Target> target = find(document, id, propertyId);
    if (!target) return target.error();
    if (Status status = validate(*target->property, value); !status) return status;
    PropertyState before = stateOf(*target->node, *target->property);
    PropertyState after = before;
    if (filmTime && before.curve) {
      Result<PropertyState> keyed = withKey(*target, *filmTime, value, {});
      if (!keyed) return keyed.error();
      after = std::move(*keyed);
    } else {
      after.plain = value;
    }
    changes.push_back({target->property, std::move(before), std::move(after)});
  }
  if (changes.empty()) return {};
  const QString text = changeText(changes, *document.node(id));
  push(document, id, std::move(changes), session, text);
  return {};
}

}  // namespace

Status setValues(SceneDocument& document, const std::string& node, const PropertyValues& values,
                 Session session) {
  return setAll(document, node, values, {}, session);
}

Status setValue(SceneDocument& document, const std::string& node, const std::string& property,
                const Value& value, Session session) {
  return setAll(document, node, {{property, value}}, {}, session);
}

Status setValueAt(SceneDocument& document, const std::string& node, const PropertyValues& values,
                  double filmTime, Session session) {
  return setAll(document, node, values, filmTime, session);
}

Status setKey(SceneDocument& document, const std::string& node, const std::string& property, double filmTime,
              const Value& value, std::optional<Interpolation> interpolation, Session session) {
  const Result<Target> target = find(document, node, property);
  if (!target) return target.error();
  if (Status status = validate(*target->property, value); !status) return status;
  Result<PropertyState> after = withKey(*target, filmTime, value, interpolation);
  if (!after) return after.error();
  push(document, node, {{target->property, stateOf(*target->node, *target->property), std::move(*after)}},
       session, QCoreApplication::translate("Edits", "Set key of %1").arg(label(*target->property)));
  return {};
}

Status removeKey(SceneDocument& document, const std::string& node, const std::string& property,
                 double filmTime) {
  const Result<Target> target = find(document, node, property);
  if (!target) return target.error();
  const PropertyState before = stateOf(*target->node, *target->property);
  const Key* key = before.curve ? before.curve->keyAt(filmTime) : nullptr;
  if (!key)
    return Error{ErrorKind::Usage, "The key cannot be removed", property, "there is no key at this time", {}};
  PropertyState after = before;
  if (before.curve->keys().size() == 1) {
    after.plain = key->value;
    after.curve.reset();
  } else {
    after.curve->removeKey(filmTime);
  }
  push(document, node, {{target->property, before, std::move(after)}}, 0,
       QCoreApplication::translate("Edits", "Remove key of %1").arg(label(*target->property)));
  return {};
}

Status moveKeys(SceneDocument& document, const std::string& id, double fromTime, double toTime,
                Session session) {
  const SceneNode* node = document.node(id);
  if (!node) return noNode(id);
  if (Status status = checkTime(toTime); !status) return status;
  std::vector<Change> changes;
  for (const auto& [propertyId, curve] : node->curves) {
    const Key* key = curve.keyAt(fromTime);
    const PropertyInfo* property = node->type->find(propertyId);
    if (!key || !property) continue;
    const PropertyState before = stateOf(*node, *property);
    PropertyState after = before;
    Key moved = *key;
    moved.time = toTime;
    after.curve->removeKey(fromTime);
    after.curve->setKey(std::move(moved));
    changes.push_back({property, before, std::move(after)});
  }
  push(document, id, std::move(changes), session, QCoreApplication::translate("Edits", "Move keys"));
  return {};
}

Status revert(SceneDocument& document, const std::string& node, const std::string& property) {
  const Result<Target> target = find(document, node, property);
  if (!target) return target.error();
  const PropertyState before = stateOf(*target->node, *target->property);
  const PropertyState after{defaultValue(*target->node->type, *target->property), {}};
  push(document, node, {{target->property, before, after}}, 0,
       QCoreApplication::translate("Edits", "Revert %1").arg(label(*target->property)));
  return {};
}

}  // namespace spin::edit
