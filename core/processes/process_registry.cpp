// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_process.h"
#include "core/sim/pipeline.h"
#include "core/snow/snow_processes.h"

namespace spin {

const std::vector<ProcessType>& processTypes() {
  static const std::vector<ProcessType> kTypes{fallProcessType(), exposureProcessType(), coverProcessType(),
                                               flowProcessType()};
  return kTypes;
}

}  // namespace spin
