// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/application.h"

int main(int argc, char** argv) {
  return spin::runEditor(argc, argv);
}
