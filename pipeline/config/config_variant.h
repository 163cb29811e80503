#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "calib/work/config_section.h"
#include "pipeline/config/build_config.h"

namespace lumi {

/// A text as it would stand in the file.
[[nodiscard]] std::string literal_of_text(const std::string& text);

/// A setting and several values of it, as they would stand in the file.
struct ConfigList {
    std::string setting;
    std::vector<std::string> literals;

    /// The values without quotation marks.
    [[nodiscard]] std::vector<std::string> words() const;
};

/// A configuration of which variants are made: the file with some settings changed.
class ConfigDocument {
 public:
    /// A file, or the configuration of a folder of photographs or a video (plain_capture.h).
    /// Throws Error (E-CONFIG-..., E-FILE-READ).
    [[nodiscard]] static ConfigDocument open(const std::filesystem::path& path);

    /// What errors call it.
    [[nodiscard]] const std::string& name() const { return name_; }
    /// The folder that paths are relative to.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

    /// True when there are tables [[key]].
    [[nodiscard]] bool has_tables(const std::string& key) const;

    /// The table `section` without the settings that `lists_of` finds below it; the rest of the
    /// file is for others to read.
    [[nodiscard]] ConfigSection options_of(const std::string& section) const;

    /// Lists that stand below tables of `section`, in the order of their names: under [sweep],
    /// depth.model = ["sparse", "sweep"]. Throws Error (E-CONFIG-VALUE) when one is no list, or an
    /// empty one.
    [[nodiscard]] std::vector<ConfigList> lists_of(const std::string& section) const;

    /// Settings in and below a table ("settings", "scene[2].settings"), each with its one value.
    [[nodiscard]] std::vector<ConfigChange> changes_of(const std::string& section) const;

    /// The configuration with settings changed. Throws Error (E-CONFIG-...) that names the line of
    /// the file, or what was changed: "fountain.toml with depth.model = ..."; E-CONFIG-DATASET for
    /// a dataset file (dataset/dataset.h).
    [[nodiscard]] BuildConfig build_config_with(const std::vector<ConfigChange>& changes) const;

 private:
    struct Document;
    std::string name_;
    std::string default_build_name_;
    std::filesystem::path folder_;
    std::shared_ptr<const Document> document_;
};

}  // namespace lumi
