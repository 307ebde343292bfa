// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/document/layer_blob.h"

#include <QDataStream>
#include <QIODevice>
#include <QtEndian>
#include <cstring>

namespace spin {
namespace {

constexpr quint32 kMagic = 0x53504c31;  // "SPL1"
constexpr qint32 kMaxSide = 65536;
/// 1 GiB unpacked: a float layer of 16384 x 16384.
constexpr quint32 kMaxUnpacked = 1u << 30;
constexpr quint8 kTypes = 1, kTemperatures = 2;

template <class T>
void packTiles(QDataStream& out, const TiledRaster<T>& layer) {
  const TiledRaster<T> blank(layer.width(), layer.height(), layer.fill());
  std::vector<std::size_t> painted;
  for (std::size_t t = 0; t < layer.tileCount(); ++t)
    if (std::memcmp(layer.tile(t)->data(), blank.tile(t)->data(), sizeof *layer.tile(t)) != 0)
      painted.push_back(t);
  const T fill = layer.fill();
  out << qint32(layer.width()) << qint32(layer.height());
  out.writeRawData(reinterpret_cast<const char*>(&fill), sizeof fill);
  out << quint32(painted.size());
  for (const std::size_t t : painted) {
    out << quint32(t);
    out.writeRawData(reinterpret_cast<const char*>(layer.tile(t)->data()), sizeof *layer.tile(t));
  }
}

template <class T>
bool unpackTiles(QDataStream& in, PaintedLayer& layer) {
  qint32 width = 0, height = 0;
  T fill{};
  quint32 count = 0;
  in >> width >> height;
  const bool whole = in.readRawData(reinterpret_cast<char*>(&fill), sizeof fill) == int{sizeof fill};
  in >> count;
  const bool sizes = width > 0 && height > 0 && width <= kMaxSide && height <= kMaxSide &&
                     qint64(width) * height * qint64{sizeof(T)} <= qint64(kMaxUnpacked);
  if (!whole || !sizes || in.status() != QDataStream::Ok) return false;
  TiledRaster<T> raster(width, height, fill);
  if (count > raster.tileCount()) return false;
  for (quint32 i = 0; i < count; ++i) {
    quint32 index = 0;
    auto tile = std::make_shared<typename TiledRaster<T>::Tile>();
    in >> index;
    const int size = int{sizeof *tile};
    if (index >= raster.tileCount() || in.readRawData(reinterpret_cast<char*>(tile->data()), size) != size)
      return false;
    raster.setTile(index, std::move(tile));
  }
  layer = std::move(raster);
  return in.atEnd();
}

}  // namespace

QByteArray packLayer(const PaintedLayer& layer) {
  QByteArray bytes;
  QDataStream out(&bytes, QIODevice::WriteOnly);
  out << kMagic;
  if (const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&layer)) {
    out << kTypes;
    packTiles(out, *types);
  } else if (const auto* kelvin = std::get_if<TiledRaster<float>>(&layer)) {
    out << kTemperatures;
    packTiles(out, *kelvin);
  }
  return qCompress(bytes, 1);
}

Result<PaintedLayer> unpackLayer(const QByteArray& bytes, const std::string& nameForMessages) {
  const Error damaged =
      badInput("The painted layer cannot be recovered", nameForMessages, "the file is damaged");
  // qCompress puts the size it unpacks to in front.
  if (bytes.size() < 4 || qFromBigEndian<quint32>(bytes.constData()) > kMaxUnpacked) return damaged;
  const QByteArray unpacked = qUncompress(bytes);
  QDataStream in(unpacked);
  quint32 magic = 0;
  quint8 kind = 0;
  in >> magic >> kind;
  PaintedLayer layer;
  const bool good = magic == kMagic && ((kind == kTypes && unpackTiles<std::uint8_t>(in, layer)) ||
                                        (kind == kTemperatures && unpackTiles<float>(in, layer)));
  if (!good) return damaged;
  return layer;
}

}  // namespace spin
