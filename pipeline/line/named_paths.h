#pragma once

#include <string>

#include "pipeline/config/build_config.h"

namespace lumi {

/// That what a configuration names beside the photographs is there, before hours of work come to
/// it: all that stages up to `last_stage` read. Throws Error (E-CONFIG-PATH) naming the key.
void expect_named_paths(const BuildConfig& config, const std::string& last_stage);

}  // namespace lumi
