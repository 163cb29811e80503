#pragma once

#include <filesystem>

#include "calib/ingest/ingest.h"

namespace lumi {

/// What the ingest stage hands on, as photographs.json beside the working copies.
void write_photograph_list(const std::filesystem::path& ingest_folder, const IngestResult& result);
/// Throws Error (E-JSON-READ).
[[nodiscard]] IngestResult read_photograph_list(const std::filesystem::path& ingest_folder);

}  // namespace lumi
