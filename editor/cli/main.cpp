// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <QCoreApplication>
#include <csignal>
#include <cstring>

#include "editor/cli/commands.h"

namespace {

spin::CancelToken& interruption() {
  static spin::CancelToken token;
  return token;
}

/// The first signal asks the job to end cleanly; a second one ends the program at once.
extern "C" void onSignal(int number) {
  interruption().cancel();
  std::signal(number, SIG_DFL);
}

}  // namespace

int main(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  const spin::CancelToken& cancel = interruption();
  // Measured cases have nothing to end cleanly: there the first signal ends the program.
  if (argc < 2 || std::strcmp(argv[1], "bench") != 0) {
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
  }
  // A reader of the progress that goes away must not end the job.
  std::signal(SIGPIPE, SIG_IGN);
  return spin::cliMain({argv + 1, argv + argc}, cancel);
}
