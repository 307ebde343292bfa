// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/models/node_list_model.h"

#include <QCoreApplication>
#include <QMimeData>
#include <algorithm>

#include "editor/commands/edits.h"
#include "editor/models/node_icons.h"

namespace spin {
namespace {

const QString kMimeType = QStringLiteral("application/x-spindrift-node");

std::vector<std::string> idsOf(const Scene& scene) {
  std::vector<std::string> ids;
  for (const SceneNode& node : scene.nodes()) ids.push_back(node.id);
  return ids;
}

int positionIn(const std::vector<std::string>& ids, const std::string& id) {
  const auto found = std::find(ids.begin(), ids.end(), id);
  return found == ids.end() ? -1 : static_cast<int>(found - ids.begin());
}

QString toolTip(const SceneNode& node) {
  const auto words = [](const char* text) { return QCoreApplication::translate("Properties", text); };
  return QStringLiteral("%1 (%2)\n%3")
      .arg(words(node.type->label), QString::fromStdString(node.id), words(node.type->doc));
}

}  // namespace

NodeListModel::NodeListModel(SceneDocument* document, QObject* parent)
    : QAbstractListModel(parent), m_document(document), m_ids(idsOf(document->scene())) {
  connect(document, &SceneDocument::changed, this, &NodeListModel::follow);
}

int NodeListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_ids.size());
}

QVariant NodeListModel::data(const QModelIndex& index, int role) const {
  const SceneNode* node = m_document->node(idAt(index));
  if (!node) return {};
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return QString::fromStdString(node->name);
    case Qt::CheckStateRole:
      return static_cast<int>(node->enabled ? Qt::Checked : Qt::Unchecked);
    case Qt::DecorationRole:
      return nodeIcon(*node->type);
    case Qt::ToolTipRole:
      return toolTip(*node);
    case IdRole:
      return QString::fromStdString(node->id);
    case TypeRole:
      return QString::fromUtf8(node->type->id);
    default:
      return {};
  }
}

bool NodeListModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const std::string id = idAt(index);
  if (id.empty()) return false;
  if (role == Qt::EditRole) return edit::renameNode(*m_document, id, value.toString()).ok();
  if (role == Qt::CheckStateRole)
    return edit::setNodeEnabled(*m_document, id, value.toInt() == Qt::Checked).ok();
  return false;
}

Qt::ItemFlags NodeListModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::ItemIsDropEnabled;
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsUserCheckable |
         Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren;
}

QStringList NodeListModel::mimeTypes() const {
  return {kMimeType};
}

QMimeData* NodeListModel::mimeData(const QModelIndexList& indexes) const {
  auto* data = new QMimeData;
  if (!indexes.isEmpty()) data->setData(kMimeType, QByteArray::fromStdString(idAt(indexes.front())));
  return data;
}

bool NodeListModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int,
                                 const QModelIndex& parent) {
  if (!data || action != Qt::MoveAction || !data->hasFormat(kMimeType)) return false;
  const int from = positionIn(m_ids, data->data(kMimeType).toStdString());
  int to = row >= 0 ? row : parent.isValid() ? parent.row() : rowCount();
  if (to > from) --to;
  if (from < 0 || to < 0 || to >= rowCount()) return false;
  // The rows have moved by the undo step; true would make the view remove the dragged one.
  std::ignore = edit::moveNode(*m_document, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
  return false;
}

QModelIndex NodeListModel::indexOf(const std::string& id) const {
  const int row = positionIn(m_ids, id);
  return row < 0 ? QModelIndex() : index(row);
}

std::string NodeListModel::idAt(const QModelIndex& index) const {
  const bool known = index.isValid() && index.row() < rowCount();
  return known ? m_ids[static_cast<std::size_t>(index.row())] : std::string();
}

void NodeListModel::follow(const ChangeEvent& event) {
  switch (event.kind) {
    case ChangeKind::Reset:
      beginResetModel();
      m_ids = idsOf(m_document->scene());
      endResetModel();
      break;
    case ChangeKind::Added:
      insertId(event.node);
      break;
    case ChangeKind::Removed:
      removeId(event.node);
      break;
    case ChangeKind::Moved:
      moveId();
      break;
    case ChangeKind::Renamed:
    case ChangeKind::Enabled:
      Q_EMIT dataChanged(indexOf(event.node), indexOf(event.node));
      break;
    case ChangeKind::Property:
    case ChangeKind::Painted:
      break;
  }
}

void NodeListModel::insertId(const std::string& id) {
  const int row = positionIn(idsOf(m_document->scene()), id);
  beginInsertRows({}, row, row);
  m_ids.insert(m_ids.begin() + row, id);
  endInsertRows();
}

void NodeListModel::removeId(const std::string& id) {
  const int row = positionIn(m_ids, id);
  if (row < 0) return;
  beginRemoveRows({}, row, row);
  m_ids.erase(m_ids.begin() + row);
  endRemoveRows();
}

/// One node moved: it is the first that differs, or the one that now stands there.
void NodeListModel::moveId() {
  const std::vector<std::string> now = idsOf(m_document->scene());
  const auto [was, is] = std::mismatch(m_ids.begin(), m_ids.end(), now.begin(), now.end());
  if (was == m_ids.end()) return;
  const int first = static_cast<int>(was - m_ids.begin());
  const bool down = was + 1 != m_ids.end() && *(was + 1) == *is;
  const int from = down ? first : positionIn(m_ids, *is);
  const int to = down ? positionIn(now, *was) : first;
  beginMoveRows({}, from, from, {}, down ? to + 1 : to);
  m_ids = now;
  endMoveRows();
}

}  // namespace spin
