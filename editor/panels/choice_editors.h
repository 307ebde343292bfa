// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "editor/panels/value_editor.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QToolButton;

namespace spin {

class BoolEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit BoolEditor(QWidget* parent);
  void show(const Value& value) override;

 private:
  QCheckBox* m_box;
};

class ChoiceEditor : public ValueEditor {
  Q_OBJECT
 public:
  ChoiceEditor(const PropertyInfo& property, QWidget* parent);
  void show(const Value& value) override;

 private:
  QComboBox* m_list;
};

/// Linear RGB, shown and chosen as sRGB.
class ColourEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit ColourEditor(QWidget* parent);
  void show(const Value& value) override;

 private:
  void choose();

  QToolButton* m_button;
  Vec3d m_linear{};
};

class TextEditor : public ValueEditor {
  Q_OBJECT
 public:
  explicit TextEditor(QWidget* parent);
  void show(const Value& value) override;

 private:
  QLineEdit* m_line;
};

/// Points in plan as text, "x y; x y"; what cannot be read is taken back.
class PointsEditor : public ValueEditor {
  Q_OBJECT
 public:
  PointsEditor(const PropertyInfo& property, QWidget* parent);
  void show(const Value& value) override;

 private:
  void take();

  const PropertyInfo& m_property;
  QLineEdit* m_line;
  QString m_shown;
};

/// A file: its stored path and a button that opens a file dialog. A file chosen there is allowed.
class PathEditor : public ValueEditor {
  Q_OBJECT
 public:
  PathEditor(SceneDocument* document, QWidget* parent);
  void show(const Value& value) override;
  /// Takes a file as if it came from the dialog.
  void takeFile(const QString& absolutePath);

 private:
  void browse();

  SceneDocument* m_document;
  QLineEdit* m_line;
};

}  // namespace spin
