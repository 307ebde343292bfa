// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

/// Small models for tests: a box of 2 x 1 x 3 units (y up in glTF and OBJ: 1 high), texture "paint.png".
namespace spin::test {

/// glTF text with the buffer inside; two placed boxes: one as it is, one 10 to the right and turned a
/// quarter. `textureUri` may be anything; empty = no texture.
std::string boxGltf(const std::string& textureUri);
/// The same packed as GLB, without a texture.
std::string boxGlb();
/// OBJ and its MTL ("box.mtl"), with normals and texture coordinates.
std::string boxObj();
std::string boxMtl(const std::string& texture);
/// ASCII PLY of the box, z up.
std::string boxPly();
/// An RGBA picture of 4 x 2 texels: red above, half of it transparent, blue below.
void writePaint(const std::string& path);

}  // namespace spin::test
