// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_process.h"
#include "core/flow/flow_process.h"
#include "core/sim/pipeline.h"
#include "core/snow/snow_processes.h"

namespace spin {

const std::vector<ProcessType>& processTypes() {
  static const std::vector<ProcessType> kTypes{fallProcessType(), exposureProcessType(), coverProcessType(),
                                               flowProcessType(), cloudProcessType()};
  return kTypes;
}

}  // namespace spin
