// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/scatter_bar.h"

#include <QActionGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalBlocker>
#include <QToolBar>

#include "core/nodes/terrain_node.h"
#include "editor/app/tool_icons.h"
#include "editor/commands/edits.h"
#include "editor/panels/field_keys.h"
#include "editor/viewport/picture_view.h"

namespace spin {
namespace {

constexpr double kDensityArea = 100.0;  // m2, of which the density is told

}  // namespace

ScatterBar::ScatterBar(QToolBar* bar, SceneDocument* document, Viewport* viewport, QObject* parent)
    : QObject(parent), m_bar(bar), m_document(document), m_viewport(viewport) {
  m_model = new QComboBox;
  m_model->setObjectName(QStringLiteral("scatterModel"));
  m_model->setToolTip(tr("The model that is copied (Ctrl + click in the view chooses it)"));
  m_model->setPlaceholderText(tr("No model"));
  connect(m_model, &QComboBox::activated, this,
          [this] { m_document->select(m_model->currentData().toString().toStdString()); });
  add(m_model);
  m_group = new QActionGroup(this);
  m_modes = {
      addMode("scatterAdd", false, tr("Scatter copies"), {}),
      addMode("scatterErase", true, tr("Take copies away, also with Shift held"), QKeySequence(Qt::Key_D))};
  addFields();
  connect(viewport, &Viewport::scatterChanged, this, &ScatterBar::showScatter);
  connect(viewport, &Viewport::brushRadiusChanged, this, &ScatterBar::showScatter);
  connect(document, &SceneDocument::changed, this, &ScatterBar::showScatter);
  setVisible(false);
}

void ScatterBar::add(QWidget* widget) {
  m_shown.push_back(m_bar->addWidget(widget));
}

QAction* ScatterBar::addMode(const char* name, bool erases, const QString& text, const QKeySequence& key) {
  const QColor colour = m_bar->palette().color(QPalette::ButtonText);
  const QIcon icon = erases ? brushIcon(BrushMode::Erase, colour) : toolIcon(Viewport::Tool::Scatter, colour);
  auto* action = new QAction(icon, text, m_group);
  action->setObjectName(QLatin1String(name));
  action->setCheckable(true);
  action->setShortcut(key);
  const QString keys = key.toString(QKeySequence::NativeText);
  action->setToolTip(keys.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, keys));
  connect(action, &QAction::triggered, this, [this, erases] { m_viewport->setScatterErases(erases); });
  m_bar->addAction(action);
  m_shown.push_back(action);
  return action;
}

QDoubleSpinBox* ScatterBar::addField(const char* name, const QString& prefix, const QString& suffix,
                                     Vec2d range, int decimals, const QString& tip) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setDecimals(decimals);
  box->setRange(range.x, range.y);
  box->setPrefix(prefix);
  box->setSuffix(suffix);
  box->setToolTip(tip);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setKeyboardTracking(false);
  add(box);
  connect(new FieldKeys(box), &FieldKeys::entered, this, [this] { m_viewport->surface()->setFocus(); });
  return box;
}

void ScatterBar::addFields() {
  m_radius = addField("scatterRadius", {}, tr(" m"), {kLeastBrushRadius, kMostBrushRadius}, 1,
                      tr("Radius of the brush (F and move the pointer; [ and ]; Ctrl + wheel)"));
  connect(m_radius, &QDoubleSpinBox::valueChanged, this, [this](double v) { m_viewport->setBrushRadius(v); });
  m_density = addField("scatterDensity", {}, tr(" per 100 m\u00b2"),
                       {kLeastDensity * kDensityArea, kMostDensity * kDensityArea}, 3,
                       tr("How many copies stand on 100 m\u00b2; a stroke fills up to this"));
  connect(m_density, &QDoubleSpinBox::valueChanged, this,
          [this](double v) { m_viewport->setScatterDensity(v / kDensityArea); });
  m_distance = addField("scatterDistance", tr("Apart "), tr(" m"), {0.0, kMostCopyDistance}, 1,
                        tr("Distance between copies at least"));
  connect(m_distance, &QDoubleSpinBox::valueChanged, this,
          [this](double v) { m_viewport->setScatterDistance(v); });
  m_turn = addField("scatterTurn", tr("Turn "), tr("\u00b0"), {0.0, 360.0}, 0,
                    tr("Range within which all copies of the model are turned at random"));
  connect(m_turn, &QDoubleSpinBox::valueChanged, this, [this](double v) { setOfNode("copy_turn_deg", v); });
  m_size = addField("scatterSize", tr("Size \u00b1"), tr(" %"), {0.0, 90.0}, 0,
                    tr("How much larger or smaller all copies of the model are at random"));
  connect(m_size, &QDoubleSpinBox::valueChanged, this,
          [this](double v) { setOfNode("copy_scale", 0.01 * v); });
}

void ScatterBar::setOfNode(const char* property, double value) {
  if (m_viewport->scatter().node().empty()) return;
  const Status status = edit::setValue(*m_document, m_viewport->scatter().node(), property, value);
  if (!status.ok()) Q_EMIT message(QString::fromStdString(status.error().text()));
}

void ScatterBar::setVisible(bool on) {
  m_visible = on;
  for (QAction* action : m_shown) action->setVisible(on);
  // Keys of what is not to be seen must not work.
  m_group->setEnabled(on);
  showScatter();
}

void ScatterBar::showModels() {
  const QSignalBlocker quiet(m_model);
  m_model->clear();
  for (const SceneNode& node : m_document->scene().nodes())
    if (node.as<ModelNode>())
      m_model->addItem(QString::fromStdString(node.name), QString::fromStdString(node.id));
  m_model->setCurrentIndex(m_model->findData(QString::fromStdString(m_viewport->scatter().node())));
}

void ScatterBar::showScatter() {
  if (!m_visible) return;
  showModels();
  const ScatterBrush& scatter = m_viewport->scatter();
  for (std::size_t k = 0; k < m_modes.size(); ++k) m_modes[k]->setChecked(scatter.erases() == (k == 1));
  const auto show = [](QDoubleSpinBox* box, double value) {
    const QSignalBlocker quiet(box);
    box->setValue(value);
  };
  show(m_radius, m_viewport->brush().tip().radius);
  show(m_density, scatter.density() * kDensityArea);
  show(m_distance, scatter.distance());
  const SceneNode* node = m_document->node(scatter.node());
  const auto* model = node ? node->as<ModelNode>() : nullptr;
  m_turn->setEnabled(model);
  m_size->setEnabled(model);
  if (!model) return;
  show(m_turn, model->copyTurnDegrees);
  show(m_size, 100.0 * model->copyScale);
}

}  // namespace spin
