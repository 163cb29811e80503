#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/evaluate/evaluation.h"

namespace lumi {

/// What one mode makes of one package, and what it took to find out.
struct Measurement {
    ModeScores scores;
    std::string gl_description;
    double cpu_s = 0.0;
};

/// Evaluations by what decides them: the package, the photographs they are compared with, the mode,
/// the OpenGL that draws, whose milliseconds no other's are compared with, and the code that draws
/// and judges.
class MeasurementCache {
 public:
    MeasurementCache(std::filesystem::path folder, std::string gl_description)
        : folder_(std::move(folder)), gl_description_(std::move(gl_description)) {}

    /// Empty when it was not measured before, or when the file is damaged.
    [[nodiscard]] std::optional<Measurement> find(const std::string& what, RenderMode mode) const;
    /// Throws Error (E-FILE-WRITE).
    void keep(const std::string& what, const Measurement& measurement) const;

 private:
    [[nodiscard]] std::filesystem::path path_of(const std::string& what, RenderMode mode) const;

    std::filesystem::path folder_;
    std::string gl_description_;
};

}  // namespace lumi
