// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QAbstractItemModelTester>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>

#include "core/nodes/terrain_node.h"
#include "editor/commands/edits.h"
#include "editor/models/issue_model.h"
#include "editor/models/node_list_model.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

class ModelsTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();
  static QStringList shown(const NodeListModel& model) {
    QStringList ids;
    for (int row = 0; row < model.rowCount(); ++row)
      ids << model.index(row).data(NodeListModel::IdRole).toString();
    return ids;
  }
  static QStringList there(const SceneDocument& document) {
    QStringList ids;
    for (const SceneNode& node : document.scene().nodes()) ids << QString::fromStdString(node.id);
    return ids;
  }

 private Q_SLOTS:
  void nodesFollowTheScene();
  void nodesKeepTheirPersistentIndex_data();
  void nodesKeepTheirPersistentIndex();
  void nodesAreEditedByUndoSteps();
  void nodesAreDragged();
  void issuesFollowTheDocument();
};

void ModelsTest::nodesFollowTheScene() {
  SceneDocument document(m_reader);
  NodeListModel model(&document);
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
  for (int i = 0; i < 4; ++i) QVERIFY(edit::addNode(document, kModelType, {}).ok());
  QCOMPARE(shown(model), there(document));
  QVERIFY(edit::removeNode(document, "model_2").ok());
  QVERIFY(edit::moveNode(document, 0, 6).ok());
  QCOMPARE(shown(model), there(document));
  while (document.undoStack()->canUndo()) {
    document.undoStack()->undo();
    QCOMPARE(shown(model), there(document));
  }
  while (document.undoStack()->canRedo()) {
    document.undoStack()->redo();
    QCOMPARE(shown(model), there(document));
  }
  document.newScene();
  QCOMPARE(shown(model), there(document));
}

void ModelsTest::nodesKeepTheirPersistentIndex_data() {
  QTest::addColumn<int>("from");
  QTest::addColumn<int>("to");
  for (int from = 0; from < 4; ++from)
    for (int to = 0; to < 4; ++to) QTest::addRow("%d to %d", from, to) << from << to;
}

void ModelsTest::nodesKeepTheirPersistentIndex() {
  QFETCH(int, from);
  QFETCH(int, to);
  SceneDocument document(m_reader);
  NodeListModel model(&document);
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
  std::vector<std::pair<QPersistentModelIndex, QString>> kept;
  for (int row = 0; row < 4; ++row)
    kept.emplace_back(model.index(row), model.index(row).data(NodeListModel::IdRole).toString());
  QVERIFY(edit::moveNode(document, static_cast<std::size_t>(from), static_cast<std::size_t>(to)).ok());
  QCOMPARE(shown(model), there(document));
  for (const auto& [index, id] : kept) QCOMPARE(index.data(NodeListModel::IdRole).toString(), id);
}

void ModelsTest::nodesAreEditedByUndoSteps() {
  SceneDocument document(m_reader);
  NodeListModel model(&document);
  const QModelIndex weather = model.indexOf("weather");
  QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
  QVERIFY(model.setData(weather, QStringLiteral("Storm"), Qt::EditRole));
  QVERIFY(model.setData(weather, Qt::Unchecked, Qt::CheckStateRole));
  QCOMPARE(changed.count(), 2);
  QCOMPARE(weather.data().toString(), QStringLiteral("Storm"));
  QVERIFY(!document.node("weather")->enabled);
  QVERIFY(!model.setData(weather, QString(), Qt::EditRole));
  QCOMPARE(document.undoStack()->count(), 2);
  QVERIFY(!weather.data(Qt::DecorationRole).value<QIcon>().isNull());
  QVERIFY(weather.data(Qt::ToolTipRole).toString().contains(QStringLiteral("weather")));
}

void ModelsTest::nodesAreDragged() {
  SceneDocument document(m_reader);
  NodeListModel model(&document);
  const QStringList before = shown(model);
  const std::unique_ptr<QMimeData> data(model.mimeData({model.index(0)}));
  QVERIFY2(!model.dropMimeData(data.get(), Qt::MoveAction, 3, 0, {}), "true would remove the dragged row");
  QCOMPARE(shown(model), (QStringList{before[1], before[2], before[0], before[3]}));
  QMimeData foreign;
  foreign.setText(QStringLiteral("x"));
  QVERIFY(!model.dropMimeData(&foreign, Qt::MoveAction, 0, 0, {}));
  QCOMPARE(document.undoStack()->count(), 1);
}

void ModelsTest::issuesFollowTheDocument() {
  SceneDocument document(m_reader);
  IssueModel model(&document);
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
  QCOMPARE(model.rowCount(), 0);
  document.setIssues(QStringLiteral("x"),
                     {{Severity::Warning, {}, {}, QStringLiteral("slow")},
                      {Severity::Error, "weather", "cloud_cover", QStringLiteral("bad")}});
  QCOMPARE(model.rowCount(), 2);
  QCOMPARE(model.index(0, IssueModel::TextColumn).data().toString(), QStringLiteral("bad"));
  QCOMPARE(model.index(0, IssueModel::NodeColumn).data().toString(), QStringLiteral("Weather"));
  QCOMPARE(model.issueAt(model.index(0, 0))->property, std::string("cloud_cover"));
  document.setIssues(QStringLiteral("x"), {});
  QCOMPARE(model.rowCount(), 0);
}

QTEST_MAIN(ModelsTest)
#include "models_test.moc"
