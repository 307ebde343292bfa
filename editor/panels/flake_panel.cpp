// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/flake_panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/commands/edits.h"
#include "editor/document/scene_document.h"
#include "editor/panels/value_editor.h"

namespace spin {
namespace {

/// What rules the growth of one flake; the rest of the node is about the whole set.
constexpr const char* kShown[] = {
    "growth",    "seed",     "largest_radius_m", "particle_diameter_m", "particles",
    "alignment", "landings", "crystal_form",     "crystal_cells",       "crystal_variety"};
constexpr int kLargestSeed = 1000000;

bool counts(const std::string& property, FlakeGrowth growth) {
  const bool crystal = growth == FlakeGrowth::Crystal;
  if (property.starts_with("crystal_")) return crystal;
  if (property == "particle_diameter_m" || property == "particles") return !crystal;
  if (property == "alignment" || property == "landings")
    return growth == FlakeGrowth::SixArms || growth == FlakeGrowth::EightArms;
  return true;
}

QString translated(const char* text) {
  return QCoreApplication::translate("Properties", text);
}

}  // namespace

FlakePanel::FlakePanel(SceneDocument* document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_picture(new QLabel(this)),
      m_measures(new QLabel(this)),
      m_progress(new QProgressBar(this)),
      m_grow(new QPushButton(this)),
      m_another(new QPushButton(this)),
      m_apply(new QPushButton(this)),
      m_form(new QFormLayout) {
  setObjectName(QStringLiteral("flakePanel"));
  m_picture->setObjectName(QStringLiteral("flakePicture"));
  m_picture->setAlignment(Qt::AlignCenter);
  m_picture->setMinimumSize(120, 120);
  m_picture->setStyleSheet(QStringLiteral("background: #000000"));
  m_measures->setObjectName(QStringLiteral("flakeMeasures"));
  m_progress->setRange(0, 1000);
  m_progress->setTextVisible(false);
  m_progress->setMaximumHeight(6);
  m_grow->setObjectName(QStringLiteral("flakeGrow"));
  m_another->setObjectName(QStringLiteral("flakeAnother"));
  m_apply->setObjectName(QStringLiteral("flakeApply"));
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {m_grow, m_another, m_apply}) buttons->addWidget(button);
  auto* rows = new QWidget;
  rows->setLayout(m_form);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(rows);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->addWidget(m_picture, 3);
  column->addWidget(m_progress);
  column->addWidget(m_measures);
  column->addLayout(buttons);
  column->addWidget(scroll, 2);
  addRows();
  connect(m_grow, &QPushButton::clicked, this, &FlakePanel::toggle);
  connect(m_another, &QPushButton::clicked, this, &FlakePanel::growAnother);
  connect(m_apply, &QPushButton::clicked, this, &FlakePanel::apply);
  connect(&m_watch, &FlakeWatch::grown, this, &FlakePanel::showStage);
  connect(&m_watch, &FlakeWatch::finished, this, [this](const QString& message) {
    if (!message.isEmpty()) m_measures->setText(message);
    showTexts();
  });
  connect(document, &SceneDocument::changed, this, &FlakePanel::followScene);
  showTexts();
  readScene();
}

void FlakePanel::addRows() {
  for (const char* id : kShown) {
    const PropertyInfo& property = *kFlakeType.find(id);
    auto* label = new QLabel(translated(property.label));
    ValueEditor* editor = makeValueEditor(property, m_document, this);
    editor->setObjectName(QStringLiteral("flake_") + QLatin1String(id));
    for (QWidget* widget : {static_cast<QWidget*>(label), static_cast<QWidget*>(editor)})
      widget->setToolTip(translated(property.doc));
    m_form->addRow(label, editor);
    m_rows[id] = {label, editor};
    connect(editor, &ValueEditor::edited, this,
            [this, &property](const Value& value) { take(property, value); });
  }
}

void FlakePanel::showRows() {
  for (const auto& [id, row] : m_rows) {
    row.editor->show(kFlakeType.find(id)->get(m_node));
    row.label->setVisible(counts(id, m_node.growth));
    row.editor->setVisible(counts(id, m_node.growth));
  }
}

/// What the scene has is what the panel starts from; the panel's own changes wait until they are applied.
void FlakePanel::followScene(const ChangeEvent& event) {
  const SceneNode* node = m_document->node(event.node);
  if (event.kind == ChangeKind::Reset || (node && node->as<FlakeNode>())) readScene();
}

void FlakePanel::readScene() {
  const SceneNode* node = m_document->scene().firstOf(kFlakeType);
  const auto* known = node ? node->as<FlakeNode>() : nullptr;
  m_node = known ? *known : FlakeNode();
  showRows();
}

void FlakePanel::take(const PropertyInfo& property, const Value& value) {
  property.set(m_node, value);
  showRows();
  m_watch.start(m_node);
  showTexts();
}

void FlakePanel::toggle() {
  if (m_watch.running())
    m_watch.stop();
  else
    m_watch.start(m_node);
  showTexts();
}

void FlakePanel::growAnother() {
  m_node.seed = (m_node.seed + 1) % kLargestSeed;
  showRows();
  m_watch.start(m_node);
  showTexts();
}

void FlakePanel::showStage(const FlakeStage& stage) {
  m_image = stage.picture;
  showPicture();
  m_progress->setValue(static_cast<int>(1000.0 * stage.share));
  const QString size = tr("radius %1 mm").arg(locale().toString(1e3 * stage.radius, 'f', 2));
  QString text = m_node.growth == FlakeGrowth::Crystal ? tr("%n cell(s) of ice", nullptr, stage.particles)
                                                       : tr("%n particle(s)", nullptr, stage.particles);
  text += QStringLiteral(", ") + size;
  if (stage.dimension > 0.0)
    text += QStringLiteral(", ") + tr("D = %1").arg(locale().toString(stage.dimension, 'f', 2));
  m_measures->setText(text);
}

void FlakePanel::showPicture() {
  if (m_image.isNull()) return;
  const int side = std::max(16, std::min(m_picture->width(), m_picture->height()));
  m_picture->setPixmap(
      QPixmap::fromImage(m_image).scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

void FlakePanel::apply() {
  edit::PropertyValues values;
  for (const char* id : kShown) values.emplace_back(id, kFlakeType.find(id)->get(m_node));
  // A new node would at once be taken for the panel's settings.
  const FlakeNode wanted = m_node;
  m_document->undoStack()->beginMacro(tr("Apply flake"));
  Status status;
  const SceneNode* node = m_document->scene().firstOf(kFlakeType);
  std::string id = node ? node->id : std::string();
  if (!node) {
    const auto added = edit::addNode(*m_document, kFlakeType, translated(kFlakeType.label));
    if (added)
      id = *added;
    else
      status = added.error();
  }
  if (status) status = edit::setValues(*m_document, id, values);
  m_document->undoStack()->endMacro();
  if (status) return;
  m_node = wanted;
  showRows();
  Q_EMIT editRefused(QString::fromStdString(status.error().text()));
}

void FlakePanel::showTexts() {
  m_grow->setText(m_watch.running() ? tr("Stop") : tr("Grow"));
  m_grow->setToolTip(m_watch.running() ? tr("Stop the growth; what has grown stays")
                                       : tr("Grow a flake with these settings and watch it"));
  m_another->setText(tr("Another"));
  m_another->setToolTip(tr("Grow another flake of the same kind: the next seed"));
  m_apply->setText(tr("Apply to scene"));
  m_apply->setToolTip(tr("Let the scene's flakes grow like this one"));
  m_picture->setToolTip(tr("The flake as it grows"));
  m_measures->setToolTip(tr("Size of the flake and its fractal dimension by the radius of gyration"));
  if (m_measures->text().isEmpty()) m_measures->setText(tr("Nothing has grown yet"));
}

void FlakePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    showTexts();
    for (const auto& [id, row] : m_rows) row.label->setText(translated(kFlakeType.find(id)->label));
  }
  QWidget::changeEvent(event);
}

void FlakePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showPicture();
}

}  // namespace spin
