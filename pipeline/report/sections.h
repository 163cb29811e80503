#pragma once

#include <string>

#include "pipeline/report/report_sources.h"

namespace lumi {

/// The parts of a report, in the order in which they are read. Each is HTML with every text
/// escaped, and empty when there is nothing to tell.

/// How it went, in colour.
[[nodiscard]] std::string verdict_section(const ReportSources& sources);
/// What `lumi build --target` was to reach, what it chose and what came of it.
[[nodiscard]] std::string target_section(const ReportSources& sources);
/// Held-out photographs beside what was drawn in their place.
[[nodiscard]] std::string pictures_section(const ReportSources& sources);
/// How close they come: figures with intervals, in every mode.
[[nodiscard]] std::string figures_section(const ReportSources& sources);
/// Charts that other commands left in the workspace or beside it.
[[nodiscard]] std::string charts_section(const ReportSources& sources);
/// What was used, what was left out and why.
[[nodiscard]] std::string photographs_section(const ReportSources& sources);
/// Where the cameras stood: the camera mesh, residuals, lenses.
[[nodiscard]] std::string cameras_section(const ReportSources& sources);
/// How far the scene is, as each view sees it.
[[nodiscard]] std::string depth_section(const ReportSources& sources);
/// Seconds and memory of every stage.
[[nodiscard]] std::string seconds_section(const ReportSources& sources);
/// Settings, versions and command lines: what it takes to do it again.
[[nodiscard]] std::string repetition_section(const ReportSources& sources);

}  // namespace lumi
