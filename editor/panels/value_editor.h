// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "core/property/property_table.h"

namespace spin {

class SceneDocument;

/// Shows and edits one value. Subclasses per kind of property; the row round it turns edits into undo steps.
class ValueEditor : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;

  /// Shows a value without telling edited().
  virtual void show(const Value& value) = 0;
  using QWidget::show;

 Q_SIGNALS:
  /// The user changed the value. `dragging` is true while a slider or arrow is held: such edits belong
  /// together.
  void edited(const spin::Value& value, bool dragging);
  /// The user let go.
  void released();
  /// Return in a field: the user is done with it.
  void entered();
};

/// The fitting editor for a property: check box, number with unit (and slider where the range is small
/// enough), three numbers, colour, list, text or file.
ValueEditor* makeValueEditor(const PropertyInfo& property, SceneDocument* document, QWidget* parent);

}  // namespace spin
