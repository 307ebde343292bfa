// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/panels/outliner_panel.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "editor/document/scene_document.h"
#include "editor/models/issue_model.h"
#include "editor/models/node_list_model.h"
#include "editor/panels/issues_panel.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

class OutlinerPanelTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();

 private Q_SLOTS:
  void selectionGoesBothWays();
  void aClickDoesNotRename();
  void nodesAreAddedAndRemoved();
  void theWindowAddsNodesAndExtendsTheMenu();
  void noIssuesAreSaid();
  void issuesLeadToTheirNode();
};

void OutlinerPanelTest::selectionGoesBothWays() {
  SceneDocument document(m_reader);
  OutlinerPanel panel(&document);
  panel.show();
  document.select("camera");
  QCOMPARE(panel.view()->currentIndex().data(NodeListModel::IdRole).toString(), QStringLiteral("camera"));
  panel.view()->setCurrentIndex(panel.view()->model()->index(0, 0));
  QCOMPARE(document.selected(), std::string("weather"));
}

/// Clicks select; only a double click and F2 rename.
void OutlinerPanelTest::aClickDoesNotRename() {
  SceneDocument document(m_reader);
  OutlinerPanel panel(&document);
  panel.resize(300, 300);
  panel.show();
  document.select("camera");
  const auto editor = [&] { return panel.view()->viewport()->findChild<QLineEdit*>(); };
  const QPoint centre = panel.view()->visualRect(panel.view()->currentIndex()).center();
  QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, centre);
  QTest::qWait(QApplication::doubleClickInterval() + 100);
  QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, centre);
  QTest::qWait(QApplication::doubleClickInterval() + 100);
  QVERIFY(!editor());
  QTest::mouseDClick(panel.view()->viewport(), Qt::LeftButton, {}, centre);
  QVERIFY(editor());
}

void OutlinerPanelTest::nodesAreAddedAndRemoved() {
  SceneDocument document(m_reader);
  OutlinerPanel panel(&document);
  panel.show();
  QMenu menu;
  panel.fillAddMenu(&menu);
  auto* weather = menu.findChild<QAction*>(QStringLiteral("add_weather"));
  auto* model = menu.findChild<QAction*>(QStringLiteral("add_model"));
  QVERIFY(weather && model);
  QVERIFY2(!weather->isEnabled(), "there is one already");
  model->trigger();
  model->trigger();
  QCOMPARE(document.selected(), std::string("model_2"));
  QCOMPARE(panel.view()->currentIndex().data(NodeListModel::IdRole).toString(), QStringLiteral("model_2"));
  panel.activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(&panel));
  panel.view()->setFocus();
  QTest::keyClick(panel.view(), Qt::Key_Delete);
  QVERIFY(!document.node("model_2"));
  QVERIFY(document.node("model"));
}

/// Who owns the panel places new nodes and says what else can be done with one.
void OutlinerPanelTest::theWindowAddsNodesAndExtendsTheMenu() {
  SceneDocument document(m_reader);
  OutlinerPanel panel(&document);
  std::string wanted;
  panel.addNode = [&](const NodeType& type) { wanted = type.id; };
  QMenu add;
  panel.fillAddMenu(&add);
  add.findChild<QAction*>(QStringLiteral("add_model"))->trigger();
  QCOMPARE(wanted, std::string("model"));
  QVERIFY(!document.node("model"));
  QString extended;
  panel.extendMenu = [&](QMenu* menu, const SceneNode& node) {
    extended = QString::fromStdString(node.id);
    menu->addAction(QStringLiteral("More"));
  };
  QMenu menu;
  panel.fillNodeMenu(&menu, "camera");
  QCOMPARE(extended, QStringLiteral("camera"));
  QVERIFY(menu.actions().size() >= 4);
  QMenu none;
  panel.fillNodeMenu(&none, {});
  QVERIFY(none.isEmpty());
}

void OutlinerPanelTest::noIssuesAreSaid() {
  SceneDocument document(m_reader);
  IssuesPanel panel(&document);
  panel.show();
  const auto* empty = panel.findChild<QLabel*>(QStringLiteral("noIssues"));
  QVERIFY(empty && empty->isVisible());
  document.setIssues(QStringLiteral("x"), {{Severity::Warning, {}, {}, QStringLiteral("slow")}});
  QVERIFY(!empty->isVisible());
  document.newScene();
  QVERIFY(empty->isVisible());
}

void OutlinerPanelTest::issuesLeadToTheirNode() {
  SceneDocument document(m_reader);
  IssuesPanel panel(&document);
  panel.resize(600, 200);
  panel.show();
  document.setIssues(QStringLiteral("x"),
                     {{Severity::Error, "weather", "cloud_cover", QStringLiteral("bad")}});
  QSignalSpy revealed(&document, &SceneDocument::revealRequested);
  const QModelIndex issue = panel.view()->model()->index(0, IssueModel::TextColumn);
  const QPoint place = panel.view()->visualRect(issue).center();
  QTest::mouseClick(panel.view()->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseDClick(panel.view()->viewport(), Qt::LeftButton, {}, place);
  QTRY_VERIFY(revealed.count() > 0);
  QCOMPARE(document.selected(), std::string("weather"));
}

QTEST_MAIN(OutlinerPanelTest)
#include "outliner_panel_test.moc"
