// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/scene_lock.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

#include "editor/document/scene_document.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

namespace {

/// One instance of the program.
struct Instance {
  Instance(std::shared_ptr<AssetReader> reader, const QString& state)
      : document(std::move(reader)), lock(&document, state) {}
  auto warnings() const {
    return std::count_if(document.issues().begin(), document.issues().end(),
                         [](const DocumentIssue& issue) { return issue.severity == Severity::Warning; });
  }
  SceneDocument document;
  SceneLock lock;
};

}  // namespace

class SceneLockTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();
  std::unique_ptr<QTemporaryDir> m_folder;
  QString scene() const { return m_folder->filePath(QStringLiteral("a.spindrift")); }
  std::unique_ptr<Instance> start() const {
    return std::make_unique<Instance>(m_reader, m_folder->filePath(QStringLiteral("state/open")));
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    m_folder = std::make_unique<QTemporaryDir>();
    SceneDocument document(m_reader);
    document.saveAs(scene());
    QVERIFY(document.finishSaving().ok());
  }

  void theSecondInstanceIsWarned() {
    const auto first = start(), second = start();
    const auto before = first->warnings();
    QVERIFY(first->document.open(scene()).ok());
    QCOMPARE(first->warnings(), before);
    QVERIFY(second->document.open(scene()).ok());
    QCOMPARE(second->warnings(), before + 1);
    QCOMPARE(first->warnings(), before);
    second->document.newScene();
    QCOMPARE(second->warnings(), before);
  }

  /// Opening the own file again is no other instance, and a closed scene is free.
  void theLockGoesWithTheScene() {
    const auto first = start(), second = start();
    const auto before = first->warnings();
    QVERIFY(first->document.open(scene()).ok());
    QVERIFY(first->document.open(scene()).ok());
    QCOMPARE(first->warnings(), before);
    first->document.newScene();
    QVERIFY(second->document.open(scene()).ok());
    QCOMPARE(second->warnings(), before);
  }

  /// Saving elsewhere moves the lock along; a save notices that the other has gone.
  void savingMovesTheLock() {
    const auto first = start(), second = start();
    const auto before = first->warnings();
    QVERIFY(first->document.open(scene()).ok());
    QVERIFY(second->document.open(scene()).ok());
    first->document.saveAs(m_folder->filePath(QStringLiteral("b.spindrift")));
    QVERIFY(first->document.finishSaving().ok());
    QCOMPARE(second->warnings(), before + 1);
    second->document.save();
    QVERIFY(second->document.finishSaving().ok());
    QCOMPARE(second->warnings(), before);
  }
};

QTEST_MAIN(SceneLockTest)
#include "scene_lock_test.moc"
