// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/choice_editors.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "editor/document/scene_document.h"
#include "editor/panels/field_keys.h"
#include "editor/panels/number_editors.h"
#include "editor/panels/wheel_guard.h"

namespace spin {
namespace {

/// Transfer function of IEC 61966-2-1 (sRGB) and its inverse.
double toSrgb(double linear) {
  const double l = std::clamp(linear, 0.0, 1.0);
  return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1.0 / 2.4) - 0.055;
}
double toLinear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

QColor shown(const Vec3d& linear) {
  return QColor::fromRgbF(static_cast<float>(toSrgb(linear.x)), static_cast<float>(toSrgb(linear.y)),
                          static_cast<float>(toSrgb(linear.z)));
}

QHBoxLayout* rowLayout(QWidget* widget) {
  auto* layout = new QHBoxLayout(widget);
  layout->setContentsMargins(0, 0, 0, 0);
  return layout;
}

}  // namespace

BoolEditor::BoolEditor(QWidget* parent) : ValueEditor(parent), m_box(new QCheckBox(this)) {
  m_box->setObjectName(QStringLiteral("check"));
  rowLayout(this)->addWidget(m_box);
  setFocusProxy(m_box);
  connect(m_box, &QCheckBox::toggled, this, [this](bool on) { Q_EMIT edited(on, false); });
}

void BoolEditor::show(const Value& value) {
  const QSignalBlocker quiet(m_box);
  m_box->setChecked(std::get<bool>(value));
}

ChoiceEditor::ChoiceEditor(const PropertyInfo& property, QWidget* parent)
    : ValueEditor(parent), m_list(new QComboBox(this)) {
  m_list->setObjectName(QStringLiteral("list"));
  m_list->setFocusPolicy(Qt::StrongFocus);
  new WheelGuard(m_list);
  for (const Choice& choice : property.choices)
    m_list->addItem(QCoreApplication::translate("Properties", choice.label));
  rowLayout(this)->addWidget(m_list, 1);
  setFocusProxy(m_list);
  connect(m_list, &QComboBox::activated, this,
          [this](int index) { Q_EMIT edited(static_cast<std::int64_t>(index), false); });
}

void ChoiceEditor::show(const Value& value) {
  m_list->setCurrentIndex(static_cast<int>(std::get<std::int64_t>(value)));
}

ColourEditor::ColourEditor(QWidget* parent) : ValueEditor(parent), m_button(new QToolButton(this)) {
  m_button->setObjectName(QStringLiteral("colour"));
  rowLayout(this)->addWidget(m_button);
  setFocusProxy(m_button);
  connect(m_button, &QToolButton::clicked, this, &ColourEditor::choose);
}

void ColourEditor::show(const Value& value) {
  m_linear = std::get<Vec3d>(value);
  QPixmap sample(32, 16);
  sample.fill(shown(m_linear));
  m_button->setIcon(sample);
}

void ColourEditor::choose() {
  const QColor colour = QColorDialog::getColor(shown(m_linear), this);
  if (colour.isValid())
    Q_EMIT edited(
        Vec3d{toLinear(static_cast<double>(colour.redF())), toLinear(static_cast<double>(colour.greenF())),
              toLinear(static_cast<double>(colour.blueF()))},
        false);
}

TextEditor::TextEditor(QWidget* parent) : ValueEditor(parent), m_line(new QLineEdit(this)) {
  m_line->setObjectName(QStringLiteral("text"));
  rowLayout(this)->addWidget(m_line, 1);
  setFocusProxy(m_line);
  connect(m_line, &QLineEdit::editingFinished, this, [this] {
    if (m_line->isModified()) Q_EMIT edited(m_line->text().toStdString(), false);
    m_line->setModified(false);
  });
  connect(new FieldKeys(m_line), &FieldKeys::entered, this, &ValueEditor::entered);
}

void TextEditor::show(const Value& value) {
  const QString text = QString::fromStdString(std::get<std::string>(value));
  if (text != m_line->text()) m_line->setText(text);
}

PathEditor::PathEditor(SceneDocument* document, QWidget* parent)
    : ValueEditor(parent), m_document(document), m_line(new QLineEdit(this)) {
  m_line->setObjectName(QStringLiteral("path"));
  auto* button = new QToolButton(this);
  button->setObjectName(QStringLiteral("browse"));
  button->setText(QStringLiteral("\u2026"));
  button->setToolTip(tr("Choose a file"));
  QHBoxLayout* layout = rowLayout(this);
  layout->addWidget(m_line, 1);
  layout->addWidget(button);
  setFocusProxy(m_line);
  connect(button, &QToolButton::clicked, this, &PathEditor::browse);
  connect(m_line, &QLineEdit::editingFinished, this, [this] {
    if (m_line->isModified()) Q_EMIT edited(m_line->text().toStdString(), false);
    m_line->setModified(false);
  });
  connect(new FieldKeys(m_line), &FieldKeys::entered, this, &ValueEditor::entered);
}

PointsEditor::PointsEditor(const PropertyInfo& property, QWidget* parent)
    : ValueEditor(parent), m_property(property), m_line(new QLineEdit(this)) {
  m_line->setObjectName(QStringLiteral("points"));
  m_line->setPlaceholderText(tr("east north; east north; ..."));
  rowLayout(this)->addWidget(m_line, 1);
  setFocusProxy(m_line);
  connect(m_line, &QLineEdit::editingFinished, this, &PointsEditor::take);
  connect(new FieldKeys(m_line), &FieldKeys::entered, this, &ValueEditor::entered);
}

void PointsEditor::take() {
  if (!m_line->isModified()) return;
  m_line->setModified(false);
  const Result<Value> read = parseValue(m_property, m_line->text().toStdString());
  if (read)
    Q_EMIT edited(*read, false);
  else
    m_line->setText(m_shown);
}

void PointsEditor::show(const Value& value) {
  m_shown = QString::fromStdString(toText(m_property, value));
  if (m_shown != m_line->text()) m_line->setText(m_shown);
}

void PathEditor::show(const Value& value) {
  const QString text = QString::fromStdString(std::get<std::string>(value));
  if (text != m_line->text()) m_line->setText(text);
  m_line->setToolTip(text);
}

void PathEditor::browse() {
  const QString folder = QFileInfo(m_document->path()).absolutePath();
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose a file"), folder);
  if (!file.isEmpty()) takeFile(file);
}

void PathEditor::takeFile(const QString& absolutePath) {
  const std::string stored = m_document->storedPath(absolutePath);
  if (!resolveAssetPath(m_document->path().toStdString(), stored, m_document->pathPolicy()))
    m_document->allowFolder(QFileInfo(absolutePath).absolutePath());
  Q_EMIT edited(stored, false);
}

ValueEditor* makeValueEditor(const PropertyInfo& property, SceneDocument* document, QWidget* parent) {
  switch (property.kind) {
    case PropertyKind::Bool:
      return new BoolEditor(parent);
    case PropertyKind::Int:
    case PropertyKind::Real:
      return new NumberEditor(property, parent);
    case PropertyKind::Vector:
      return new VectorEditor(property, parent);
    case PropertyKind::Colour:
      return new ColourEditor(parent);
    case PropertyKind::Choice:
      return new ChoiceEditor(property, parent);
    case PropertyKind::Points:
      return new PointsEditor(property, parent);
    case PropertyKind::Text:
      return new TextEditor(parent);
    case PropertyKind::Path:
      return new PathEditor(document, parent);
  }
  return new TextEditor(parent);
}

}  // namespace spin
