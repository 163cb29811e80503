#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/ingest/ingest.h"
#include "pipeline/evaluate/judged_view.h"

namespace lumi {

/// The pictures of an evaluation: for each view a strip of photograph, rendering and error by each
/// mode and method, and maps of the first mode's errors. They stand upright, as the EXIF data of
/// the photographs say, whose figures are of the pictures as the sensor saw them.
class EvaluationPictures {
 public:
    /// `photographs` are the capture's, and may be more.
    EvaluationPictures(const Capture& capture, const std::vector<Photograph>& photographs,
                       RenderMode first_mode);

    void write(const std::filesystem::path& folder, RenderMode mode, const JudgedView& view) const;
    /// A rival's strip.
    void write(const std::filesystem::path& folder, const std::string& method,
               const JudgedView& view) const;

    /// Names of files: those of the mode that stands first have no mode in theirs.
    [[nodiscard]] std::string strip(const std::string& view, RenderMode mode) const;
    [[nodiscard]] std::string strip(const std::string& view, const std::string& method) const;
    /// `kind` is "flip" or "ghost".
    [[nodiscard]] std::string map(const std::string& view, const std::string& kind) const;

 private:
    void write_strip(const std::filesystem::path& path, const JudgedView& view) const;

    std::map<std::string, std::string> stem_of_;
    std::map<std::string, int> exif_orientation_of_;
    RenderMode first_mode_;
};

/// The names of the pictures that an evaluation.json tells of, whichever version wrote it; of one
/// that cannot be read those that it tells of all the same, or none.
[[nodiscard]] std::set<std::string> names_of_pictures(const nlohmann::ordered_json& evaluation);

}  // namespace lumi
