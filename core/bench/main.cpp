// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/bench_case.h"
#ifdef SPIN_HAVE_EMBREE
#include "core/raycast/embree_ray_scene.h"
#endif

int main(int argc, char** argv) {
#ifdef SPIN_HAVE_EMBREE
  const spin::RaySceneFactory makeRayScene = spin::makeEmbreeRayScene;
#else
  const spin::RaySceneFactory makeRayScene = spin::makeBvhRayScene;
#endif
  return spin::benchMain({argv + 1, argv + argc}, spin::builtInBenchCases(), makeRayScene);
}
