// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/property_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "core/nodes/cover_nodes.h"
#include "core/nodes/node_registry.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "editor/commands/edits.h"
#include "editor/document/time_context.h"
#include "editor/panels/number_editors.h"
#include "editor/panels/property_row_editor.h"
#include "editor/panels/unit_spin_box.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

class PropertyPanelTest : public QObject {
  Q_OBJECT
 private:
  std::unique_ptr<SceneDocument> m_document;
  std::unique_ptr<TimeContext> m_time;
  std::unique_ptr<PropertyPanel> m_panel;
  template <class T>
  T* part(const char* property, const char* name) const {
    const auto* row = m_panel->findChild<PropertyRowEditor*>(QString::fromUtf8(property));
    return row ? row->template findChild<T*>(QString::fromUtf8(name)) : nullptr;
  }
  Value value(const std::string& node, const char* property) const {
    const SceneNode* found = m_document->node(node);
    const PropertyInfo* info = found ? found->type->find(property) : nullptr;
    return info ? plainValue(*found, *info) : Value();
  }
  double weather(const char* property) const { return std::get<double>(value("weather", property)); }
  bool isRevertShown(const char* property) const {
    const auto* button = part<QToolButton>(property, "revert");
    return button && button->isVisible();
  }
  static void type(QWidget* widget, const char* text) {
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(widget, QString::fromUtf8(text));
    QTest::keyClick(widget, Qt::Key_Return);
  }

 private Q_SLOTS:
  void init() {
    QLocale::setDefault(QLocale::c());
    makePanel();
  }
  void makePanel() {
    m_panel.reset();
    m_document = std::make_unique<SceneDocument>(std::make_shared<FakeAssetReader>());
    m_time = std::make_unique<TimeContext>(m_document.get());
    m_panel = std::make_unique<PropertyPanel>(m_document.get(), m_time.get());
    m_panel->resize(500, 600);
    m_panel->show();
    m_document->select("weather");
  }
  void everyPropertyHasARow();
  void unitsAreShownAndTakenBack();
  void untouchedValuesKeepTheirDigits();
  void aDecimalCommaIsTaken();
  void aSliderDragIsOneStep();
  void slidersOverDecadesGoByRatio();
  void keyButtonSetsAndRemovesKeys();
  void revertButtonFollowsTheValue();
  void otherKindsAreEdited();
  void refusedEditsAreTold();
  void revealFocusesTheRow();
  void undoIsShown();
  void theWheelNeedsTheFocus();
  void undoPassesUnlessTheFieldHasSome_data();
  void undoPassesUnlessTheFieldHasSome();
  void returnIsTold();
};

void PropertyPanelTest::everyPropertyHasARow() {
  for (const NodeType* type : nodeTypes()) {
    const SceneNode* there = m_document->scene().firstOf(*type);
    m_document->select(there ? there->id : *edit::addNode(*m_document, *type, {}));
    for (const PropertyRow& property : type->properties) {
      PropertyRowEditor* row = m_panel->row(property.id);
      QVERIFY2(row, property.id);
      QCOMPARE(row->toolTip(), QString::fromUtf8(property.doc));
      QVERIFY(row->findChild<QWidget*>(QStringLiteral("editor")));
      QCOMPARE(row->keyState() != PropertyRowEditor::KeyState::NotAnimatable, property.animatable);
    }
  }
  QVERIFY(!m_panel->row("wind_speed_m_s"));
}

void PropertyPanelTest::unitsAreShownAndTakenBack() {
  auto* spin = part<UnitSpinBox>("air_temperature_k", "number");
  QCOMPARE(spin->text(), QStringLiteral("-5 \u00b0C"));
  type(spin, "-12.5");
  QCOMPARE(weather("air_temperature_k"), 260.65);
  auto* rate = part<UnitSpinBox>("precipitation_rate_kg_m2_s", "number");
  QCOMPARE(rate->text(), QStringLiteral("5 mm/h"));
  type(rate, "500");
  QCOMPARE(weather("precipitation_rate_kg_m2_s"), 500.0 / 3600.0);
  QCOMPARE(m_document->undoStack()->count(), 2);
}

void PropertyPanelTest::untouchedValuesKeepTheirDigits() {
  const double fine = 3.123456789012345;
  QVERIFY(edit::setValue(*m_document, "weather", "wind_speed_m_s", fine).ok());
  auto* spin = part<UnitSpinBox>("wind_speed_m_s", "number");
  QCOMPARE(spin->si(), fine);
  spin->setFocus();
  QTest::keyClick(spin, Qt::Key_Return);
  QCOMPARE(weather("wind_speed_m_s"), fine);
  QCOMPARE(m_document->undoStack()->count(), 1);
}

void PropertyPanelTest::aDecimalCommaIsTaken() {
  QLocale::setDefault(QLocale(QLocale::Czech));
  makePanel();
  auto* spin = part<UnitSpinBox>("wind_speed_m_s", "number");
  type(spin, "3,25");
  QCOMPARE(weather("wind_speed_m_s"), 3.25);
  QCOMPARE(spin->text(), QStringLiteral("3,25 m/s"));
  type(spin, "4.5");
  QCOMPARE(weather("wind_speed_m_s"), 4.5);
}

void PropertyPanelTest::aSliderDragIsOneStep() {
  auto* slider = part<QSlider>("cloud_cover", "slider");
  QVERIFY(slider);
  slider->setSliderDown(true);
  for (int step = 9; step <= 15; ++step) slider->setValue(step);
  slider->setSliderDown(false);
  QCOMPARE(weather("cloud_cover"), 0.75);
  QCOMPARE(m_document->undoStack()->count(), 1);
  slider->setSliderDown(true);
  slider->setValue(20);
  slider->setSliderDown(false);
  QCOMPARE(m_document->undoStack()->count(), 2);
  m_document->undoStack()->undo();
  m_document->undoStack()->undo();
  QCOMPARE(weather("cloud_cover"), 0.4);
  QCOMPARE(slider->value(), 8);
}

/// Ranges over decades: the middle is the geometric one, both ends are reached, and all places lead back.
void PropertyPanelTest::slidersOverDecadesGoByRatio() {
  int found = 0;
  for (const NodeType* type : nodeTypes())
    for (const PropertyRow& row : type->properties) {
      if (!slidesByRatio(row)) continue;
      ++found;
      const int most = slot(row, row.max);
      QCOMPARE(slot(row, row.min), 0);
      QCOMPARE(valueAtSlot(row, 0), row.min);
      QVERIFY2(std::abs(valueAtSlot(row, most) - row.max) < 0.05 * row.max, row.id);
      double last = row.min;
      for (int place = 1; place <= most; ++place) {
        const double value = valueAtSlot(row, place);
        QVERIFY2(value >= last && value <= row.max, row.id);
        last = value;
      }
      QVERIFY2(valueAtSlot(row, most / 2) < 0.2 * row.max, row.id);
    }
  QVERIFY(found > 10);
  const PropertyInfo* wind = kWeatherType.find("wind_speed_m_s");
  QVERIFY2(wind && !slidesByRatio(*wind), "a range that is read off as it is");
  m_document->select({});
  QVERIFY(edit::addNode(*m_document, kHeatSourceType, QStringLiteral("Heat"), "heat").ok());
  auto* slider = part<QSlider>("radius_m", "slider");
  QVERIFY(slider);
  slider->setValue(slider->maximum() / 2);
  const double radius = std::get<double>(value("heat", "radius_m"));
  QVERIFY(radius > 20.0 && radius < 50.0);
}

void PropertyPanelTest::keyButtonSetsAndRemovesKeys() {
  using State = PropertyRowEditor::KeyState;
  PropertyRowEditor* row = m_panel->row("wind_speed_m_s");
  auto* key = part<QToolButton>("wind_speed_m_s", "key");
  QCOMPARE(row->keyState(), State::NoKeys);
  QTest::mouseClick(key, Qt::LeftButton);
  QCOMPARE(row->keyState(), State::AtKey);
  m_time->setFrame(24);
  QCOMPARE(row->keyState(), State::BetweenKeys);
  auto* spin = part<UnitSpinBox>("wind_speed_m_s", "number");
  type(spin, "12");
  QCOMPARE(row->keyState(), State::AtKey);
  QCOMPARE(m_document->node("weather")->curves.at("wind_speed_m_s").keys().size(), 2u);
  m_time->setFrame(12);
  QCOMPARE(spin->si(), 7.0);
  m_time->setFrame(24);
  QTest::mouseClick(key, Qt::LeftButton);
  QCOMPARE(row->keyState(), State::BetweenKeys);
  QCOMPARE(spin->si(), 2.0);
}

void PropertyPanelTest::revertButtonFollowsTheValue() {
  auto* revert = part<QToolButton>("wind_speed_m_s", "revert");
  QVERIFY(!isRevertShown("wind_speed_m_s"));
  type(part<UnitSpinBox>("wind_speed_m_s", "number"), "9");
  QVERIFY(isRevertShown("wind_speed_m_s"));
  QTest::mouseClick(revert, Qt::LeftButton);
  QVERIFY(!isRevertShown("wind_speed_m_s"));
  QCOMPARE(weather("wind_speed_m_s"), 2.0);
}

void PropertyPanelTest::otherKindsAreEdited() {
  m_document->select("render");
  part<QCheckBox>("show_flakes", "check")->click();
  type(part<QLineEdit>("caption", "text"), "Kontertal");
  type(part<UnitSpinBox>("width_px", "number"), "1920");
  QCOMPARE(value("render", "show_flakes"), Value(false));
  QCOMPARE(value("render", "caption"), Value(std::string("Kontertal")));
  QCOMPARE(value("render", "width_px"), Value(std::int64_t{1920}));
  m_document->select("camera");
  type(part<UnitSpinBox>("position_m", "y"), "-80");
  QCOMPARE(value("camera", "position_m"), Value(Vec3d{0, -80, 20}));
  const std::string model = *edit::addNode(*m_document, kModelType, {});
  auto* list = part<QComboBox>("up_axis", "list");
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Down);
  QCOMPARE(value(model, "up_axis"), Value(static_cast<std::int64_t>(ModelUpAxis::Y)));
  type(part<QLineEdit>("source", "path"), "models/hut.gltf");
  QCOMPARE(value(model, "source"), Value(std::string("models/hut.gltf")));
}

void PropertyPanelTest::refusedEditsAreTold() {
  m_document->select("render");
  QSignalSpy refused(m_panel.get(), &PropertyPanel::editRefused);
  auto* caption = part<QLineEdit>("caption", "text");
  caption->setText(QString(5000, QLatin1Char('x')));
  caption->setModified(true);
  QTest::keyClick(caption, Qt::Key_Return);
  QCOMPARE(refused.count(), 1);
  QVERIFY(caption->text().isEmpty());
}

void PropertyPanelTest::revealFocusesTheRow() {
  m_document->reveal("simulation", "last_frame");
  PropertyRowEditor* row = m_panel->row("last_frame");
  QVERIFY(row);
  const QWidget* focused = m_panel->focusWidget();
  QVERIFY(focused && row->isAncestorOf(focused));
}

void PropertyPanelTest::undoIsShown() {
  auto* spin = part<UnitSpinBox>("wind_speed_m_s", "number");
  type(spin, "9");
  m_document->undoStack()->undo();
  QCOMPARE(spin->si(), 2.0);
  QVERIFY(edit::removeNode(*m_document, "weather").ok());
  QVERIFY(!m_panel->row("wind_speed_m_s"));
}

void PropertyPanelTest::theWheelNeedsTheFocus() {
  auto* spin = part<UnitSpinBox>("wind_speed_m_s", "number");
  auto* slider = part<QSlider>("cloud_cover", "slider");
  auto* list = part<QComboBox>("precipitation_phase", "list");
  const double cloud = weather("cloud_cover");
  m_panel->setFocus();
  for (QWidget* widget :
       {static_cast<QWidget*>(spin), static_cast<QWidget*>(slider), static_cast<QWidget*>(list)}) {
    QWheelEvent turn(QPointF(5, 5), widget->mapToGlobal(QPointF(5, 5)), {}, QPoint(0, -120), Qt::NoButton,
                     Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &turn);
  }
  QCOMPARE(weather("wind_speed_m_s"), 2.0);
  QCOMPARE(weather("cloud_cover"), cloud);
  QCOMPARE(list->currentIndex(), 0);
}

void PropertyPanelTest::undoPassesUnlessTheFieldHasSome_data() {
  QTest::addColumn<QByteArray>("node");
  QTest::addColumn<QByteArray>("property");
  QTest::newRow("number") << QByteArray("weather") << QByteArray("wind_speed_m_s");
  QTest::newRow("text") << QByteArray("render") << QByteArray("caption");
}

/// A field keeps Ctrl+Z only while it holds typing that is not taken yet.
void PropertyPanelTest::undoPassesUnlessTheFieldHasSome() {
  QFETCH(QByteArray, node);
  QFETCH(QByteArray, property);
  m_document->select(node.toStdString());
  QWidget* field = part<QWidget>(property.constData(), "editor")->focusProxy();
  QVERIFY(field);
  const auto keeps = [&](Qt::KeyboardModifiers keys) {
    QKeyEvent event(QEvent::ShortcutOverride, Qt::Key_Z, keys);
    event.ignore();
    QCoreApplication::sendEvent(field, &event);
    return event.isAccepted();
  };
  field->setFocus();
  QVERIFY(!keeps(Qt::ControlModifier));
  QVERIFY(!keeps(Qt::ControlModifier | Qt::ShiftModifier));
  QTest::keyClicks(field, QStringLiteral("7"));
  QVERIFY(keeps(Qt::ControlModifier));
  QTest::keyClick(field, Qt::Key_Return);
  QVERIFY(!keeps(Qt::ControlModifier));
}

void PropertyPanelTest::returnIsTold() {
  QSignalSpy entered(m_panel.get(), &PropertyPanel::entered);
  type(part<UnitSpinBox>("wind_speed_m_s", "number"), "9");
  QTRY_COMPARE(entered.count(), 1);
  QCOMPARE(weather("wind_speed_m_s"), 9.0);
  m_document->select("render");
  type(part<QLineEdit>("caption", "text"), "Kontertal");
  QTRY_COMPARE(entered.count(), 2);
  QCOMPARE(value("render", "caption"), Value(std::string("Kontertal")));
}

QTEST_MAIN(PropertyPanelTest)
#include "property_panel_test.moc"
