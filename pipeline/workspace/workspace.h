#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "pipeline/workspace/folder_lock.h"

namespace lumi {

/// Every stage, in the order of the line; each has a folder of its name.
inline constexpr std::array<const char*, 6> kAllStages{"ingest", "calibrate", "poses",
                                                       "mesh",   "depth",     "pack"};

/// Where the things of a workspace lie; other tools rely on these names.
class WorkspaceLayout {
 public:
    /// `name` is that of the package. A slash at the end of the folder is dropped and one that is
    /// only pointed at (".", "..") spelled out, as others are named after it.
    WorkspaceLayout(const std::filesystem::path& folder, std::string name);

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] std::filesystem::path config_path() const { return folder_ / "config.toml"; }
    [[nodiscard]] std::filesystem::path stages_path() const { return folder_ / "stages.json"; }
    [[nodiscard]] std::filesystem::path report_path() const { return folder_ / "report.html"; }
    [[nodiscard]] std::filesystem::path package_folder() const {
        return folder_ / (name_ + ".lumi");
    }
    [[nodiscard]] std::filesystem::path evaluation_folder() const { return folder_ / "evaluation"; }
    [[nodiscard]] std::filesystem::path stage_folder(const std::string& stage) const {
        return folder_ / stage;
    }

 private:
    std::filesystem::path folder_;
    std::string name_;
};

/// A workspace that this process alone works in.
class Workspace : public WorkspaceLayout {
 public:
    /// Makes the folder, locks it and removes what a killed run left behind. Throws Error
    /// (E-WORKSPACE-BUSY, E-FILE-WRITE; E-WORKSPACE-FOREIGN where files that no workspace wrote
    /// would be replaced).
    explicit Workspace(const WorkspaceLayout& layout);

 private:
    FolderLock lock_;
};

/// What an evaluation and a plan leave in their folders.
inline constexpr const char* kEvaluationName = "evaluation.json";
inline constexpr const char* kPlanName = "plan.json";

/// The first line of a workspace's configuration, without its end: by it a folder is known for one.
inline constexpr const char* kWorkspaceConfigHeader =
    "# Written by lumi: every default, and paths that hold anywhere. It can be built from, too.";

/// The folder that a package lies in, with or without a slash at the end of its name.
[[nodiscard]] std::filesystem::path folder_around(const std::filesystem::path& package_folder);

/// Whether a stage was finished there.
[[nodiscard]] bool has_finished_stage(const WorkspaceLayout& layout);

/// Whether the folder has a configuration that lumi wrote; or one that was edited or converted
/// since, beside what lumi wrote down of its runs and a stage that it finished.
[[nodiscard]] bool is_workspace(const std::filesystem::path& folder);

/// The layout of a workspace that `lumi build` made (is_workspace), by its config.toml. Throws
/// Error (E-WORKSPACE-NONE) when there is none.
[[nodiscard]] WorkspaceLayout find_workspace(const std::filesystem::path& folder);

}  // namespace lumi
