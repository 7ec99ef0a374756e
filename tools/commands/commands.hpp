// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "arguments/arguments.hpp"
#include "exit_status.hpp"

namespace tool {

Exit run_info(const Arguments& arguments);
Exit run_fit(const Arguments& arguments);
Exit run_map(const Arguments& arguments);
Exit run_unmap(const Arguments& arguments);
Exit run_dimension(const Arguments& arguments);
Exit run_batch(const Arguments& arguments);
Exit run_decompose(const Arguments& arguments);
Exit run_denoise(const Arguments& arguments);
Exit run_compare(const Arguments& arguments);
Exit run_events(const Arguments& arguments);
Exit run_live(const Arguments& arguments);
Exit run_synthesize(const Arguments& arguments);

} // namespace tool
