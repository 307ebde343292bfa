// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/autosave.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "editor/commands/edits.h"
#include "editor/document/layer_blob.h"
#include "tests/support/fake_asset_reader.h"

using namespace spin;

class AutosaveTest : public QObject {
  Q_OBJECT
 private:
  std::shared_ptr<FakeAssetReader> m_reader = std::make_shared<FakeAssetReader>();
  std::unique_ptr<QTemporaryDir> m_folder;
  QString state() const { return m_folder->filePath(QStringLiteral("state")); }
  /// As after a crash: the files stay, the lock is of a program that is gone.
  void leaveUnsavedWork(double wind) const {
    SceneDocument document(m_reader);
    Autosave autosave(&document, state(), 0);
    QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", wind).ok());
    QVERIFY(autosave.flush().ok());
  }

 private Q_SLOTS:
  void init() {
    QSettings().clear();
    m_folder = std::make_unique<QTemporaryDir>();
  }
  void changesAreWrittenSoon();
  void unsavedWorkIsRecovered();
  void paintedLayersAreRecovered();
  void aFileSavedAfterTheCrashIsSeen();
  void aLiveSceneIsNotOffered();
  void savingRemovesTheCopy();
  void undoneWorkNeedsNoCopy();
  void decliningRemovesTheCopy();
  void damagedCopiesAreNoCrash();
  void layerBytesAreChecked();
};

void AutosaveTest::changesAreWrittenSoon() {
  SceneDocument document(m_reader);
  Autosave autosave(&document, state(), 20);
  QSignalSpy written(&autosave, &Autosave::written);
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 9.0).ok());
  QCOMPARE(written.count(), 0);
  QTRY_COMPARE(written.count(), 1);
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 10.0).ok());
  QTRY_COMPARE(written.count(), 2);
}

void AutosaveTest::unsavedWorkIsRecovered() {
  leaveUnsavedWork(9.0);
  SceneDocument document(m_reader);
  Autosave autosave(&document, state());
  const std::vector<Recovery> found = autosave.recoverable();
  QCOMPARE(found.size(), 1u);
  QVERIFY(found[0].scenePath.isEmpty());
  QVERIFY(qAbs(found[0].written.secsTo(QDateTime::currentDateTimeUtc())) < 60);
  QVERIFY(autosave.recover(found[0]).ok());
  QCOMPARE(document.node("weather")->as<WeatherNode>()->windSpeed, 9.0);
  QVERIFY(document.isModified());
  QVERIFY2(QDir(found[0].folder).exists(), "the copy stays until the user saved or declined");
  document.saveAs(m_folder->filePath(QStringLiteral("a.spindrift")));
  QVERIFY(document.finishSaving().ok());
  QTRY_VERIFY(!QDir(found[0].folder).exists());
}

void AutosaveTest::paintedLayersAreRecovered() {
  TiledRaster<std::uint8_t> layer(200, 100, kUnpaintedGround);
  layer.set(150, 70, 6);
  {
    SceneDocument document(m_reader);
    Autosave autosave(&document, state());
    const std::string node = *edit::addNode(document, kGroundTypeLayerType, {});
    QVERIFY(edit::paint(document, node, layer, 0).ok());
    QVERIFY(autosave.flush().ok());
  }
  SceneDocument document(m_reader);
  Autosave autosave(&document, state());
  QVERIFY(autosave.recover(autosave.recoverable().at(0)).ok());
  QVERIFY(document.node("ground_type")->painted == PaintedLayer(layer));
}

/// The recovered scene still knows what its file was, so that a save does not overwrite a newer one unasked.
void AutosaveTest::aFileSavedAfterTheCrashIsSeen() {
  const QString file = m_folder->filePath(QStringLiteral("a.spindrift"));
  {
    SceneDocument document(m_reader);
    Autosave autosave(&document, state(), 0);
    document.saveAs(file);
    QVERIFY(document.finishSaving().ok());
    QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 9.0).ok());
    QVERIFY(autosave.flush().ok());
  }
  SceneDocument document(m_reader);
  Autosave autosave(&document, state());
  QVERIFY(autosave.recover(autosave.recoverable().at(0)).ok());
  QCOMPARE(document.path(), file);
  QVERIFY(!document.isChangedOnDisk());
  SceneDocument newer(m_reader);
  QVERIFY(newer.open(file).ok());
  QVERIFY(edit::setValue(newer, "weather", "wind_speed_m_s", 3.0).ok());
  newer.save();
  QVERIFY(newer.finishSaving().ok());
  QVERIFY(document.isChangedOnDisk());
}

void AutosaveTest::aLiveSceneIsNotOffered() {
  SceneDocument document(m_reader);
  Autosave autosave(&document, state());
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 9.0).ok());
  QVERIFY(autosave.flush().ok());
  SceneDocument second(m_reader);
  Autosave other(&second, state());
  QVERIFY(other.recoverable().empty());
}

void AutosaveTest::savingRemovesTheCopy() {
  SceneDocument document(m_reader);
  Autosave autosave(&document, state());
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 9.0).ok());
  QVERIFY(autosave.flush().ok());
  const auto folders = [&] { return QDir(state()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(); };
  QCOMPARE(folders(), 1);
  document.saveAs(m_folder->filePath(QStringLiteral("a.spindrift")));
  QVERIFY(document.finishSaving().ok());
  QTRY_COMPARE(folders(), 0);
}

void AutosaveTest::undoneWorkNeedsNoCopy() {
  SceneDocument document(m_reader);
  Autosave autosave(&document, state(), 1);
  QVERIFY(edit::setValue(document, "weather", "wind_speed_m_s", 9.0).ok());
  QVERIFY(autosave.flush().ok());
  document.undoStack()->undo();
  QTRY_COMPARE(QDir(state()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 0);
}

void AutosaveTest::decliningRemovesTheCopy() {
  leaveUnsavedWork(9.0);
  leaveUnsavedWork(10.0);
  SceneDocument document(m_reader);
  Autosave autosave(&document, state());
  QCOMPARE(autosave.recoverable().size(), 2u);
  autosave.discard(autosave.recoverable()[0]);
  QCOMPARE(autosave.recoverable().size(), 1u);
  QVERIFY(autosave.recover(autosave.recoverable()[0]).ok());
  QCOMPARE(document.node("weather")->as<WeatherNode>()->windSpeed, 9.0);
  autosave.forget();
  QTRY_COMPARE(QDir(state()).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 0);
}

void AutosaveTest::damagedCopiesAreNoCrash() {
  leaveUnsavedWork(9.0);
  SceneDocument document(m_reader);
  Autosave autosave(&document, state());
  const Recovery found = autosave.recoverable().at(0);
  QFile scene(QDir(found.folder).filePath(QStringLiteral("scene.spindrift")));
  QVERIFY(scene.resize(scene.size() / 2));
  QVERIFY(!autosave.recover(found).ok());
  QVERIFY(!document.isModified());
  QFile info(QDir(found.folder).filePath(QStringLiteral("info.json")));
  QVERIFY(info.resize(3));
  QVERIFY(autosave.recoverable().empty());
}

void AutosaveTest::layerBytesAreChecked() {
  TiledRaster<float> layer(100, 70, 0.0f);
  layer.set(99, 69, 271.5f);
  const QByteArray good = packLayer(layer);
  QVERIFY(*unpackLayer(good, "l") == PaintedLayer(layer));
  QVERIFY(!unpackLayer({}, "l").ok());
  QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("qUncompress")));
  QVERIFY(!unpackLayer(good.left(good.size() - 3), "l").ok());
  QVERIFY(!unpackLayer(QByteArray("\xff\xff\xff\xff garbage"), "l").ok());
  const QByteArray plain = qUncompress(good);
  for (const auto& [offset, byte] :
       std::vector<std::pair<int, char>>{{0, 'x'}, {4, '\x09'}, {5, '\x7f'}, {9, '\xff'}, {17, '\x7f'}}) {
    QByteArray bad = plain;
    bad[offset] = byte;
    QVERIFY2(!unpackLayer(qCompress(bad), "l").ok(), qPrintable(QString::number(offset)));
  }
}

QTEST_MAIN(AutosaveTest)
#include "autosave_test.moc"
