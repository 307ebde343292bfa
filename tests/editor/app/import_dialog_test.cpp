// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/import_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>

#include "tests/editor/support/strict.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

class ImportDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { test::failOnWarnings(); }

  void kindsByEnding() {
    QVERIFY(importKindOf(QStringLiteral("a/DEM.TIF")) == ImportKind::Terrain);
    QVERIFY(importKindOf(QStringLiteral("hut.glb")) == ImportKind::Model);
    QVERIFY(importKindOf(QStringLiteral("notes.txt")) == ImportKind::Unknown);
  }

  /// What is in the file is shown before it can be accepted; options lead to another reading and to the
  /// node's properties.
  void terrainIsShownFirst() {
    ImportDialog dialog(std::make_shared<test::FakeReader>(), QStringLiteral("dem.asc"), ImportKind::Terrain);
    auto* accept = dialog.findChild<QPushButton*>(QStringLiteral("importAccept"));
    auto* table = dialog.findChild<QTableWidget*>(QStringLiteral("importSummary"));
    QVERIFY(!accept->isEnabled());
    QTRY_VERIFY(dialog.ready());
    QVERIFY(accept->isEnabled());
    QCOMPARE(table->item(0, 1)->text(), QStringLiteral("4 m"));
    QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("importWarnings"))
                ->text()
                .contains(QStringLiteral("a warning")));
    QCOMPARE(dialog.options().epsg, 0);
    QVERIFY(dialog.findings().view.has_value());
    dialog.findChild<QSpinBox*>(QStringLiteral("epsg"))->setValue(31287);
    dialog.findChild<QPushButton*>(QStringLiteral("importAgain"))->click();
    QTRY_VERIFY(dialog.ready());
    QCOMPARE(table->item(1, 1)->text(), QStringLiteral("31287"));
    QCOMPARE(dialog.options().epsg, 31287);
    dialog.findChild<QDoubleSpinBox*>(QStringLiteral("cellSize"))->setValue(10.0);
    QVERIFY2(!dialog.findings().view.has_value(), "the view was that of other cells");
  }

  void copyIsOfferedUnlessTheFileLiesBesideTheScene() {
    ImportDialog dialog(std::make_shared<test::FakeReader>(), QStringLiteral("hut.glb"), ImportKind::Model);
    auto* copy = dialog.findChild<QCheckBox*>(QStringLiteral("copyBeside"));
    QVERIFY(dialog.copyWanted());
    copy->setChecked(false);
    QVERIFY(!dialog.copyWanted());
    copy->setChecked(true);
    dialog.hideCopy();
    QVERIFY(copy->isHidden());
    QVERIFY(!dialog.copyWanted());
  }

  void brokenFilesCannotBeAccepted() {
    ImportDialog dialog(std::make_shared<test::FakeReader>(), QStringLiteral("broken.glb"),
                        ImportKind::Model);
    auto* text = dialog.findChild<QLabel*>(QStringLiteral("importWarnings"));
    QTRY_VERIFY(text->text().contains(QStringLiteral("it is broken")));
    QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("importAccept"))->isEnabled());
  }

  void modelOptionsBecomeProperties() {
    ImportDialog dialog(std::make_shared<test::FakeReader>(), QStringLiteral("hut.glb"), ImportKind::Model);
    QTRY_VERIFY(dialog.ready());
    dialog.findChild<QComboBox*>(QStringLiteral("upAxis"))->setCurrentIndex(2);
    QCOMPARE(dialog.options().upAxis, 2);
  }
};

QTEST_MAIN(ImportDialogTest)
#include "import_dialog_test.moc"
