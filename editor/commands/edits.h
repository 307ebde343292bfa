// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/property/scene_node.h"
#include "core/scene/import_scene.h"
#include "editor/document/scene_document.h"

/// All changes of a scene. Each checks its input, pushes one undo step and returns an Error where nothing was
/// done. Edits with the same session (one drag, one stroke) on the same thing become one undo step.
namespace spin::edit {

/// 0 never merges.
using Session = quint64;
/// A number no other session has.
Session newSession();

using PropertyValues = std::vector<std::pair<std::string, Value>>;

/// Sets plain values of one node together (a gizmo moves and turns in one step).
Status setValues(SceneDocument& document, const std::string& node, const PropertyValues& values,
                 Session session = 0);
Status setValue(SceneDocument& document, const std::string& node, const std::string& property,
                const Value& value, Session session = 0);
/// What widgets call: sets a key at the film time where the property is animated, else the plain value.
Status setValueAt(SceneDocument& document, const std::string& node, const PropertyValues& values,
                  double filmTime, Session session = 0);

/// Inserts or replaces a key. The interpolation is kept where a key is replaced and taken from the key before
/// otherwise, unless named.
Status setKey(SceneDocument& document, const std::string& node, const std::string& property, double filmTime,
              const Value& value, std::optional<Interpolation> interpolation = {}, Session session = 0);
/// Removes a key; with the last key goes the animation, and the plain value becomes the key's.
Status removeKey(SceneDocument& document, const std::string& node, const std::string& property,
                 double filmTime);
/// Moves all keys of a node that stand at one film time to another one, replacing keys there.
Status moveKeys(SceneDocument& document, const std::string& node, double fromTime, double toTime,
                Session session = 0);
/// Back to the default value, keys removed.
Status revert(SceneDocument& document, const std::string& node, const std::string& property);

/// Adds a node with defaults and selects it; the id comes from the wish or the type. Position: behind all.
Result<std::string> addNode(SceneDocument& document, const NodeType& type, const QString& name,
                            const std::string& idWish = {});
/// What an import knows besides the file.
struct AssetDetails {
  ImportOptions options;
  std::string credit;             ///< of a terrain, as the file tells
  std::optional<FirstView> view;  ///< of a terrain
  std::optional<Vec3d> position;  ///< of a model
  bool copyOnSave = false;        ///< a file outside the scene's folder is copied at the next save
};
/// Adds a terrain or model node for a file, stored relative to the scene; one undo step. The folder of a file
/// from outside that is not to be copied is allowed from then on. The first terrain of a scene turns the
/// camera to it and lets it snow where nobody has set that up. A further terrain takes the place of the one
/// there is, of which only the cover's settings stay.
Result<std::string> addAssetNode(SceneDocument& document, const NodeType& type, const QString& file,
                                 const AssetDetails& details = {});
Result<std::string> duplicateNode(SceneDocument& document, const std::string& node);
Status removeNode(SceneDocument& document, const std::string& node);
/// Moves the node at a row so that it stands at another row afterwards.
Status moveNode(SceneDocument& document, std::size_t from, std::size_t to);
Status renameNode(SceneDocument& document, const std::string& node, const QString& name);
Status setNodeEnabled(SceneDocument& document, const std::string& node, bool enabled);

/// Copies all files from outside the scene's folder into its NAME.assets/, with the files they refer to, and
/// makes the nodes use the copies: one undo step. The scene must have been saved once. Returns the number of
/// nodes whose file was copied.
Result<int> collectFiles(SceneDocument& document);

/// Takes over a painted layer; the undo step keeps only the tiles that changed.
Status paint(SceneDocument& document, const std::string& node, const PaintedLayer& layer, Session session);

}  // namespace spin::edit
