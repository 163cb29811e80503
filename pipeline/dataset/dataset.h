#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/error.h"
#include "pipeline/config/build_config.h"

namespace lumi {

/// A scene of a dataset: its configuration, or why it has none.
struct DatasetScene {
    std::string name;  ///< Of its folder and of its package, whatever its own file calls it.
    BuildConfig config;
    std::optional<Error> failure;  ///< Empty when the configuration could be read.
};

/// Several scenes that are built with one command:
///
///     name = "arena"
///     [settings]                      # for every scene; any setting of a configuration
///     depth.model = "sweep"
///     [[scene]]
///     config = "fountain.toml"        # relative to this file
///     [[scene]]
///     photos = "chair.2/"             # a folder of photographs, all else as by default
///     name = "chair"                  # else as the file without its ending, or as the folder
///     settings.evaluate.hold_out_every = 8
struct Dataset {
    std::string name;
    std::vector<DatasetScene> scenes;
};

/// True for a TOML file with [[scene]] tables.
[[nodiscard]] bool is_dataset_file(const std::filesystem::path& path);

/// Throws Error: E-CONFIG-... about the file itself (E-CONFIG-VALUE when its name or that of a
/// scene cannot name a folder), E-DATASET-NAME when two scenes have one name. What is wrong with a
/// scene's own configuration is that scene's failure.
[[nodiscard]] Dataset read_dataset(const std::filesystem::path& path);

}  // namespace lumi
