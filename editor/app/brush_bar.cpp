// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/brush_bar.h"

#include <QActionGroup>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolBar>
#include <QToolButton>

#include "core/nodes/flow_nodes.h"
#include "editor/app/layer_tools.h"
#include "editor/app/tool_icons.h"
#include "editor/panels/field_keys.h"
#include "editor/panels/layer_value_editor.h"
#include "editor/viewport/picture_view.h"

namespace spin {

BrushBar::BrushBar(QToolBar* bar, Viewport* viewport, LayerTools* layers, QObject* parent)
    : QObject(parent), m_bar(bar), m_viewport(viewport) {
  addLayer();
  addModes();
  addTip();
  addPressure();
  addLayerMenu(layers);
  connect(viewport, &Viewport::brushChanged, this, &BrushBar::showBrush);
  showBrush();
  setVisible(false);
}

void BrushBar::add(QWidget* widget) {
  m_shown.push_back(m_bar->addWidget(widget));
}

void BrushBar::addLayer() {
  m_layer = new QComboBox;
  m_layer->setObjectName(QStringLiteral("brushLayer"));
  m_layer->setToolTip(tr("What the brush paints; a selected painted node takes its place"));
  for (const PaintedKind& kind : paintedKinds())
    if (kind.type != &kAvalancheReleaseType)
      m_layer->addItem(QCoreApplication::translate("Properties", kind.label),
                       QVariant::fromValue(static_cast<const void*>(&kind)));
  connect(m_layer, &QComboBox::activated, this, [this] {
    const auto* kind = static_cast<const PaintedKind*>(m_layer->currentData().value<const void*>());
    m_viewport->setBrushLayer(*kind);
    showBrush();
  });
  add(m_layer);
  m_value = new LayerValueEditor;
  m_value->setObjectName(QStringLiteral("brushValue"));
  m_value->setToolTip(tr("What the brush paints (Ctrl + click in the view picks it)"));
  connect(m_value, &LayerValueEditor::edited, this, [this] { m_viewport->setBrushValue(m_value->si()); });
  connect(m_value, &LayerValueEditor::entered, this, [this] { m_viewport->surface()->setFocus(); });
  add(m_value);
  m_valueShown = m_shown.back();
}

void BrushBar::addModes() {
  m_modes = new QActionGroup(this);
  const auto mode = [this](const char* name, BrushMode which, const QString& text, const QKeySequence& key) {
    auto* action = new QAction(brushIcon(which, m_bar->palette().color(QPalette::ButtonText)), text, m_modes);
    action->setObjectName(QLatin1String(name));
    action->setCheckable(true);
    action->setShortcut(key);
    action->setData(static_cast<int>(which));
    const QString keys = key.toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, keys));
    connect(action, &QAction::triggered, this, [this, which] { m_viewport->setBrushMode(which); });
    m_bar->addAction(action);
    m_shown.push_back(action);
  };
  mode("brushPaint", BrushMode::Paint, tr("Paint"), {});
  mode("brushSmooth", BrushMode::Smooth, tr("Smooth, also with Shift held"), {});
  mode("brushErase", BrushMode::Erase, tr("Erase to not painted"), QKeySequence(Qt::Key_D));
  mode("brushPick", BrushMode::Pick, tr("Pick a value, also with Ctrl held"), QKeySequence(Qt::Key_I));
}

std::vector<QAction*> BrushBar::modes() const {
  const QList<QAction*> all = m_modes->actions();
  return {all.begin(), all.end()};
}

void BrushBar::addTip() {
  m_radius = new QDoubleSpinBox;
  m_radius->setObjectName(QStringLiteral("brushRadius"));
  m_radius->setRange(kLeastBrushRadius, kMostBrushRadius);
  m_radius->setDecimals(1);
  m_radius->setSuffix(tr(" m"));
  m_radius->setToolTip(tr("Radius of the brush (F and move the pointer; [ and ]; Ctrl + wheel)"));
  m_radius->setKeyboardTracking(false);
  add(m_radius);
  connect(m_radius, &QDoubleSpinBox::valueChanged, this, &BrushBar::takeTip);
  connect(new FieldKeys(m_radius), &FieldKeys::entered, this, [this] { m_viewport->surface()->setFocus(); });
  m_strength = addPercent("brushStrength", tr("Strength "),
                          tr("How far a stroke goes towards the value (Shift+F and move the pointer)"));
  m_strengthShown = m_shown.back();
  m_hardness = addPercent("brushHardness", tr("Hardness "),
                          tr("Share of the radius that has the full strength: the inner ring"));
  m_hardnessShown = m_shown.back();
}

QSpinBox* BrushBar::addPercent(const char* name, const QString& prefix, const QString& tip) {
  auto* box = new QSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setRange(0, 100);
  box->setSingleStep(5);
  box->setPrefix(prefix);
  box->setSuffix(tr(" %"));
  box->setToolTip(tip);
  box->setKeyboardTracking(false);
  add(box);
  connect(box, &QSpinBox::valueChanged, this, &BrushBar::takeTip);
  connect(new FieldKeys(box), &FieldKeys::entered, this, [this] { m_viewport->surface()->setFocus(); });
  return box;
}

void BrushBar::addPressure() {
  m_pressure = new QToolButton;
  m_pressure->setObjectName(QStringLiteral("brushPressure"));
  m_pressure->setText(tr("Pen"));
  m_pressure->setToolTip(tr("What the pressure of a pen changes"));
  m_pressure->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(m_pressure);
  menu->setToolTipsVisible(true);
  const auto toggle = [&](const char* name, const QString& text, const QString& tip) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setCheckable(true);
    action->setToolTip(tip);
    connect(action, &QAction::triggered, this, [this] {
      m_viewport->setBrushPressure(m_pressStrength->isChecked(), m_pressRadius->isChecked());
    });
    return action;
  };
  m_pressStrength =
      toggle("pressStrength", tr("Pressure changes the strength"), tr("A light touch paints little"));
  m_pressRadius = toggle("pressRadius", tr("Pressure changes the radius"), tr("A light touch paints narrow"));
  m_pressure->setMenu(menu);
  add(m_pressure);
}

void BrushBar::addLayerMenu(LayerTools* layers) {
  auto* button = new QToolButton;
  button->setObjectName(QStringLiteral("layerMenuButton"));
  button->setText(tr("Layer"));
  button->setToolTip(tr("What is done to the whole layer: fill, filters, files"));
  button->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(button);
  fillLayerMenu(menu, layers);
  button->setMenu(menu);
  add(button);
}

void BrushBar::fillLayerMenu(QMenu* menu, LayerTools* layers) {
  menu->setToolTipsVisible(true);
  const auto item = [&](const char* name, const QString& text, const QString& tip,
                        void (LayerTools::*what)()) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setToolTip(tip);
    connect(action, &QAction::triggered, layers, what);
  };
  item("layerFill", tr("&Fill..."), tr("Fill by altitude, slope and aspect"), &LayerTools::fill);
  item("layerFilter", tr("F&ilter..."), tr("Blur, grow, shrink and more"), &LayerTools::filter);
  item("layerClear", tr("&Clear"), tr("Take away all that is painted"), &LayerTools::clear);
  menu->addSeparator();
  item("layerImport", tr("I&mport..."), tr("Take the layer from a picture or a GeoTIFF"),
       &LayerTools::importFile);
  item("layerExport", tr("&Export..."), tr("Write the layer as a picture or a GeoTIFF"),
       &LayerTools::exportFile);
}

void BrushBar::setVisible(bool on) {
  m_visible = on;
  for (QAction* action : m_shown) action->setVisible(on);
  // Keys of what is not to be seen must not work.
  m_modes->setEnabled(on);
  if (on) showBrush();
}

void BrushBar::showBrush() {
  const GroundBrush& brush = m_viewport->brush();
  const PaintedKind& kind = brush.kind();
  const bool release = kind.type == &kAvalancheReleaseType;
  m_layer->setCurrentIndex(m_layer->findData(QVariant::fromValue(static_cast<const void*>(&kind))));
  m_layer->setPlaceholderText(QCoreApplication::translate("Properties", kind.label));
  m_value->showKind(kind, brush.value());
  m_valueShown->setVisible(m_visible && !release);
  m_hardnessShown->setVisible(m_visible && !kind.numbers);
  m_strengthShown->setVisible(m_visible && !kind.numbers);
  for (QAction* action : m_modes->actions())
    action->setChecked(action->data().toInt() == static_cast<int>(brush.mode()));
  const QSignalBlocker quietRadius(m_radius), quietHardness(m_hardness), quietStrength(m_strength);
  m_radius->setValue(brush.tip().radius);
  m_hardness->setValue(qRound(100.0 * brush.tip().hardness));
  m_strength->setValue(qRound(100.0 * brush.tip().strength));
  m_pressStrength->setChecked(brush.pressesStrength());
  m_pressRadius->setChecked(brush.pressesRadius());
}

void BrushBar::takeTip() {
  // Only what was edited: the fields show rounded numbers.
  BrushTip tip = m_viewport->brush().tip();
  if (sender() == m_radius) tip.radius = m_radius->value();
  if (sender() == m_hardness) tip.hardness = 0.01 * m_hardness->value();
  if (sender() == m_strength) tip.strength = 0.01 * m_strength->value();
  m_viewport->setBrushTip(tip);
}

}  // namespace spin
